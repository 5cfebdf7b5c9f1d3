#include "contenders.hpp"

#include <limits>

#include "contensou/law/batch.hpp"
#include "contensou/law/hertz.hpp"
#include "contensou/law/uniform.hpp"
#include "rivals/elliptic.hpp"
#include "rivals/printed.hpp"

namespace accuracy {
namespace {

using Batch = void (*)(std::span<const double>, contensou::ReducedBatch);

template <class Law>
Contender scalar(std::string pressure, Law law) {
  return {std::move(pressure), "exact", true, true, [law](std::span<const double> u) {
            std::vector<Values> values;
            for (const double x : u) {
              const auto [phi, xi, eta] = contensou::reduced(law, x);
              values.push_back({phi, xi, eta, law.curvature(x, 1.0).vv});
            }
            return values;
          }};
}

Contender batch(std::string pressure, Batch reduced_batch) {
  return {std::move(pressure), "exact_batch", true, false, [reduced_batch](std::span<const double> u) {
            std::vector<double> phi(u.size());
            std::vector<double> xi(u.size());
            std::vector<double> eta(u.size());
            reduced_batch(u, {phi, xi, eta});
            std::vector<Values> values;
            for (std::size_t i = 0; i < u.size(); ++i) {
              values.push_back({phi[i], xi[i], eta[i], std::numeric_limits<double>::quiet_NaN()});
            }
            return values;
          }};
}

Contender rival(std::string pressure, std::string method, const rivals::ClosedForm& form) {
  return {std::move(pressure), std::move(method), false, true, [form](std::span<const double> u) {
            std::vector<Values> values;
            for (const double x : u) {
              const auto [phi, xi, eta] = form.at(x);
              values.push_back({phi, xi, eta, form.second(x)});
            }
            return values;
          }};
}

}  // namespace

std::vector<Contender> contenders() {
  return {scalar("uniform", contensou::UniformLaw{}),
          batch("uniform", contensou::reduced_uniform),
          rival("uniform", "textbook_ke_boost", rivals::textbook_boost),
          rival("uniform", "textbook_ke_boost_promoted", rivals::textbook_boost_promoted),
          rival("uniform", "textbook_ke_gsl", rivals::textbook_gsl),
          rival("uniform", "carlson_boost", rivals::carlson_boost),
          rival("uniform", "printed_series", rivals::printed_uniform),
          scalar("hertz", contensou::HertzLaw{}),
          batch("hertz", contensou::reduced_hertz),
          rival("hertz", "printed", rivals::printed_hertz)};
}

}  // namespace accuracy
