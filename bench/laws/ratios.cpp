#include "ratios.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "common/stopwatch.hpp"
#include "contensou/law/batch.hpp"
#include "contensou/law/hertz.hpp"
#include "contensou/law/uniform.hpp"
#include "methods.hpp"
#include "rivals/elliptic.hpp"
#include "sample.hpp"

namespace bench {
namespace {

constexpr std::size_t values = 16384;

struct Ratio {
  std::string name;
  std::size_t numerator;
  std::size_t denominator;
  double aim;
  bool at_least;  ///< the aim is to reach at least, not at most, this value
};

}  // namespace

contensou::Table measure_ratios() {
  const std::vector<double> u = log_uniform_sample(values);
  std::vector<double> k(values);
  std::transform(u.begin(), u.end(), k.begin(), [](double x) { return std::min(x, 1 / x); });
  std::vector<double> phi(values);
  std::vector<double> xi(values);
  std::vector<double> eta(values);
  const contensou::ReducedBatch out{phi, xi, eta};

  const Method uniform =
      scalar_method("", "", "", [](double x) { return contensou::reduced(contensou::UniformLaw{}, x); });
  const Method hertz =
      scalar_method("", "", "", [](double x) { return contensou::reduced(contensou::HertzLaw{}, x); });
  volatile double sink = 0;
  const auto elliptic = [&] {
    for (std::size_t i = 0; i < values; ++i) phi[i] = rivals::one_k_and_one_e(k[i]);
  };
  const auto elliptic_chain = [&] {
    double nothing = 0;
    for (const double x : k) nothing = 0 * rivals::one_k_and_one_e(x + nothing);
    sink = nothing;
  };
  enum { ke, ke_chain, uniform_each, uniform_chain, hertz_each, hertz_chain, uniform_batch, hertz_batch };
  const double count = values;
  const std::vector<Task> tasks{{elliptic, count},
                                {elliptic_chain, count},
                                {[&] { uniform.evaluate(u, out); }, count},
                                {[&] { sink = uniform.chain(u); }, count},
                                {[&] { hertz.evaluate(u, out); }, count},
                                {[&] { sink = hertz.chain(u); }, count},
                                {[&] { contensou::reduced_uniform(u, out); }, count},
                                {[&] { contensou::reduced_hertz(u, out); }, count}};
  const auto seconds = time_interleaved(tasks, {.rounds = 41, .visit = 4e-3, .budget = 10});

  const std::vector<Ratio> ratios{{"uniform / (K + E), throughput", uniform_each, ke, 1, false},
                                  {"uniform / (K + E), latency", uniform_chain, ke_chain, 1, false},
                                  {"hertz / (K + E), throughput", hertz_each, ke, 1, false},
                                  {"hertz / (K + E), latency", hertz_chain, ke_chain, 1, false},
                                  {"hertz / uniform, throughput", hertz_each, uniform_each, 1, false},
                                  {"hertz / uniform, latency", hertz_chain, uniform_chain, 1, false},
                                  {"uniform, one by one / batch", uniform_each, uniform_batch, 4, true},
                                  {"hertz, one by one / batch", hertz_each, hertz_batch, 4, true}};
  contensou::Table table{{"Ratios of time per value of u, phi, xi and eta together; all measured in the same "
                          "run on the same 16384 values of u,",
                          "log-uniform over 1e-3 to 1e3 in random order. K + E: one boost::math::ellint_1(k) "
                          "plus one ellint_2(k) with",
                          "promote_double<false>, k = min(u, 1/u). throughput: independent values; latency: "
                          "each value waits for the one before.",
                          "value: median of the ratio over 41 interleaved rounds, with its quartiles; "
                          "seconds: of numerator and denominator."},
                         {"ratio", "value", "aim", "reached", "lower_quartile", "upper_quartile",
                          "seconds_numerator", "seconds_denominator"},
                         {}};
  for (const Ratio& r : ratios) {
    std::vector<double> of_round;
    for (std::size_t i = 0; i < seconds[r.numerator].size(); ++i) {
      of_round.push_back(seconds[r.numerator][i] / seconds[r.denominator][i]);
    }
    const double value = quantile(of_round);
    const bool reached = r.at_least ? value >= r.aim : value < r.aim;
    const std::string aim = (r.at_least ? ">= " : "< ") + contensou::to_text(r.aim);
    table.add({r.name, value, aim, std::string(reached ? "yes" : "no"), quantile(of_round, 0.25),
               quantile(of_round, 0.75), quantile(seconds[r.numerator]), quantile(seconds[r.denominator])});
    std::printf("  %-32s %6.3f   aim %-5s %s\n", r.name.c_str(), value, aim.c_str(),
                reached ? "reached" : "not reached");
  }
  return table;
}

}  // namespace bench
