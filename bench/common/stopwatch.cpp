#include "stopwatch.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <numeric>
#include <random>

namespace bench {
namespace {

double seconds_of(const std::function<void()>& pass) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  pass();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

std::vector<std::vector<double>> time_interleaved(std::span<const Task> tasks, const Effort& effort) {
  std::vector<std::vector<double>> seconds(tasks.size());
  std::vector<double> spent(tasks.size(), 0.0);
  std::vector<std::size_t> order(tasks.size());
  std::iota(order.begin(), order.end(), 0);
  std::mt19937 shuffle(2003);
  for (int round = 0; round < effort.rounds; ++round) {
    std::shuffle(order.begin(), order.end(), shuffle);
    for (const std::size_t task : order) {
      if (spent[task] > effort.budget && round >= effort.least) continue;
      double visit = 0;
      double fastest = std::numeric_limits<double>::infinity();
      do {
        const double pass = seconds_of(tasks[task].pass);
        visit += pass;
        fastest = std::min(fastest, pass);
      } while (visit < effort.visit);
      spent[task] += visit;
      seconds[task].push_back(fastest / tasks[task].evaluations);
    }
  }
  return seconds;
}

double quantile(std::vector<double> values, double q) {
  std::sort(values.begin(), values.end());
  const double at = q * static_cast<double>(values.size() - 1);
  const std::size_t below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  const double weight = at - static_cast<double>(below);
  return (1 - weight) * values[below] + weight * values[above];
}

}  // namespace bench
