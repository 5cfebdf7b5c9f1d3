#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "cases.hpp"
#include "code_groups.hpp"

namespace verify::absent {

/// What the steps of a scene cost: the difference of two runs, one twice as long as the other, so that
/// reading the scene and writing results cancel.
struct StepCosts {
  double steps = 0;                          ///< in the difference
  double instructions = 0;                   ///< a step
  std::map<std::string, double> calls, own;  ///< by code group, a step: calls, and instructions in them
};

/// `contensou simulate` on a scene, counted; `folder` is there. Throws std::runtime_error where it fails.
StepCosts count_steps(const std::string& scene_file, const std::vector<std::string>& options, double duration,
                      const std::filesystem::path& folder);
StepCosts count_steps(const CountedScene& scene, const std::filesystem::path& folder);

/// A new folder that goes when this does.
class Folder {
 public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace verify::absent
