#pragma once

#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <queue>
#include <string>
#include <thread>
#include <vector>

#include "sweep_crew.hpp"

namespace cli {

/// The runs that nobody has begun yet; each is handed out once.
class RunsLeft {
 public:
  explicit RunsLeft(std::vector<std::size_t> runs) : runs_(std::move(runs)) {}
  std::optional<std::size_t> next();
  /// None is handed out any more.
  void stop();

 private:
  std::mutex mutex_;
  std::vector<std::size_t> runs_;
  std::size_t begun_ = 0;
};

/// Threads that compute runs as long as there are any, and put the rows in a queue.
class SweepWorkers {
 public:
  using Compute = std::function<std::string(std::size_t)>;
  SweepWorkers(unsigned count, RunsLeft& runs, const Compute& compute);
  ~SweepWorkers();  ///< stops the runs left and waits for those begun
  SweepWorkers(const SweepWorkers&) = delete;
  SweepWorkers& operator=(const SweepWorkers&) = delete;

  /// A finished row; none if there is none within `patience`, or will be none any more.
  std::optional<std::string> row(std::chrono::microseconds patience);
  /// Whether all threads have ended and all rows have been taken.
  bool finished();

 private:
  void work();

  RunsLeft& runs_;
  const Compute& compute_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::queue<std::string> rows_;
  unsigned busy_;
  std::vector<std::thread> threads_;
};

/// The leader's side of SweepWork::take and stop: remembers what take() threw and lets no more runs begin.
class Taker {
 public:
  Taker(const SweepWork& work, RunsLeft& runs) : work_(work), runs_(runs) {}
  void take(const std::string& row);
  void look_for_stop();
  /// Throws what take() threw.
  void finish() const;

 private:
  const SweepWork& work_;
  RunsLeft& runs_;
  std::exception_ptr failure_;
};

}  // namespace cli
