#pragma once

#include <functional>
#include <span>
#include <vector>

namespace bench {

/// Something to time: one pass makes `evaluations` evaluations.
struct Task {
  std::function<void()> pass;
  double evaluations;
};

struct Effort {
  int rounds = 15;      ///< visits to each task
  double visit = 2e-3;  ///< seconds a visit lasts at least (one pass at least)
  double budget =
      1.5;  ///< seconds after which a slow task is visited no more, once it has had `least` visits
  int least = 3;
};

/// Seconds per evaluation, [task][round]. Every round visits every task once,
/// in an order shuffled anew, so that whatever else the machine does hits all
/// alike; a visit keeps its fastest pass, which is the one least disturbed.
std::vector<std::vector<double>> time_interleaved(std::span<const Task> tasks, const Effort& effort);

/// The q-quantile (0.5: the median) of at least one value.
double quantile(std::vector<double> values, double q = 0.5);

}  // namespace bench
