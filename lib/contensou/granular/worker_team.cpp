#include "contensou/granular/worker_team.hpp"

namespace contensou {

WorkerTeam::WorkerTeam(int size) : size_(size), barrier_(size) {
  for (int k = 1; k < size; ++k) threads_.emplace_back([this, k] { serve(k); });
}

WorkerTeam::~WorkerTeam() {
  ended_ = true;
  meet();
  for (std::thread& thread : threads_) thread.join();
}

void WorkerTeam::serve(int worker) {
  while (true) {
    barrier_.arrive_and_wait();
    if (ended_) return;
    call_(work_, worker);
    barrier_.arrive_and_wait();
  }
}

}  // namespace contensou
