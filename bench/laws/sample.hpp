#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace bench {

/// The range of u over which cost and error are measured.
constexpr double least_u = 1e-3;
constexpr double largest_u = 1e3;

/// `count` values of u, one at random in each of `count` equal
/// cells of log u over [least_u, largest_u], in random order.
std::vector<double> log_uniform_sample(std::size_t count);

/// The law at exact u, to the 64 bits of a long double.
struct Exact {
  double u;
  long double phi;
  long double xi;
  long double eta;
};

/// The rows of a table of reference_data/laws with least_u <= u <= largest_u.
std::vector<Exact> read_exact(const std::filesystem::path& path);

}  // namespace bench
