#include "sample.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

#include "contensou/output/table.hpp"

namespace bench {

std::vector<double> log_uniform_sample(std::size_t count) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> within(0, 1);
  std::vector<double> u;
  u.reserve(count);
  const double decades = std::log(largest_u / least_u);
  for (std::size_t k = 0; k < count; ++k) {
    u.push_back(least_u *
                std::exp(decades * (static_cast<double>(k) + within(random)) / static_cast<double>(count)));
  }
  std::shuffle(u.begin(), u.end(), random);
  return u;
}

std::vector<Exact> read_exact(const std::filesystem::path& path) {
  const contensou::Table table = contensou::read_table(path);
  const std::vector<std::string> phi = table.texts("phi");
  const std::vector<std::string> xi = table.texts("xi");
  const std::vector<std::string> eta = table.texts("eta");
  const std::vector<double> u = table.numbers("u");
  const auto number = [](const std::string& text) { return std::strtold(text.c_str(), nullptr); };
  std::vector<Exact> rows;
  for (std::size_t i = 0; i < u.size(); ++i) {
    if (u[i] >= least_u && u[i] <= largest_u)
      rows.push_back({u[i], number(phi[i]), number(xi[i]), number(eta[i])});
  }
  return rows;
}

}  // namespace bench
