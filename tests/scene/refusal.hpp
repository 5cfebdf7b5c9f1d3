#pragma once

#include <string>

#include "contensou/scene/document.hpp"

namespace contensou::test {

/// The one line with which something is refused; empty where it is not.
template <class Act>
std::string refusal_of(const Act& act) {
  try {
    act();
  } catch (const SceneError& error) {
    return error.what();
  }
  return "";
}

}  // namespace contensou::test
