#pragma once

#include <set>
#include <string>

#include "contensou/scene/variations.hpp"

namespace contensou {

/// A variation being made: a scene's document, changed key by key, with the options that say so.
struct VariationEdit {
  VariationEdit(const SceneDocument& document, std::string effect, std::string variant);

  void set(const std::string& key, const std::string& value);
  /// A key or a table, where it is there.
  void unset(const std::string& key);

  Variation variation;
};

// Changes of one contact, whose keys begin with `table`, "contact.NAME."; keys left unused are unset.
void make_exact(VariationEdit& edit, const std::string& table);
void make_ellipsoid(VariationEdit& edit, const std::string& table);
void make_uncoupled(VariationEdit& edit, const std::string& table);
void make_coulomb(VariationEdit& edit, const std::string& table);
void make_frictionless(VariationEdit& edit, const std::string& table);
void make_pressure(VariationEdit& edit, const std::string& table, const std::string& pressure);

/// The tables one level below one: "body" has "body.ball", however deep their keys.
std::set<std::string> tables_below(const SceneDocument& document, const std::string& table);

}  // namespace contensou
