#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "contensou/scene/document.hpp"

namespace contensou {

/// One key of a scene, and the values it takes in a study, each as `--set` would write it.
struct GridAxis {
  std::string key;
  std::vector<std::string> values;
};

/// Reads "KEY=A:B:N", N numbers from A to B, both included, evenly spaced; "KEY=A:B:N:log", the same with
/// even ratios (A and B of one sign); or "KEY=V1,V2,...", values in TOML, words without quotes. Numbers A, B
/// and those that are round between them come out exact. Throws SceneError, "--vary ...", for anything else.
GridAxis parse_axis(std::string_view text);

/// All combinations of the values of several keys. Runs are numbered from 0; the last key varies fastest.
struct Grid {
  std::vector<GridAxis> axes;

  /// How many runs; 1 without an axis.
  std::size_t size() const;
  /// The values of one run, by axis; run < size().
  std::vector<std::string> values(std::size_t run) const;
};

/// More runs than this are likelier a slip than a wish.
inline constexpr std::size_t most_runs = 1'000'000;

/// Throws SceneError where two axes share a key or undo each other (contact.body and contact.body.mu),
/// or where they make more than most_runs.
Grid make_grid(std::vector<GridAxis> axes);

/// The document of one run: `document` with the run's values put in. Throws SceneError as set_value().
SceneDocument at(const Grid& grid, std::size_t run, SceneDocument document);

/// A run as messages name it: "run 7 (contact.body.radius=1e-05, initial.psi_dot=180)".
std::string describe(const Grid& grid, std::size_t run);

}  // namespace contensou
