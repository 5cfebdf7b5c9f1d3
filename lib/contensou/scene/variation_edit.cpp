#include "contensou/scene/variation_edit.hpp"

#include <utility>

namespace contensou {

VariationEdit::VariationEdit(const SceneDocument& document, std::string effect, std::string variant) {
  variation.effect = std::move(effect);
  variation.variant = std::move(variant);
  variation.document = document;
}

void VariationEdit::set(const std::string& key, const std::string& value) {
  set_value(variation.document, key + '=' + value);
  variation.options.push_back("--set " + key + '=' + value);
}

void VariationEdit::unset(const std::string& key) {
  const SceneDocument::Values& values = variation.document.values;
  if (!values.contains(key)) {
    const auto below = values.lower_bound(key + '.');
    if (below == values.end() || !below->first.starts_with(key + '.')) return;
  }
  unset_value(variation.document, key);
  variation.options.push_back("--unset " + key);
}

void make_exact(VariationEdit& edit, const std::string& table) { edit.unset(table + "model"); }
void make_ellipsoid(VariationEdit& edit, const std::string& table) { edit.set(table + "model", "ellipsoid"); }
void make_uncoupled(VariationEdit& edit, const std::string& table) { edit.set(table + "model", "uncoupled"); }

void make_coulomb(VariationEdit& edit, const std::string& table) {
  for (const char* key : {"pressure", "table_radius", "table_pressure", "radius", "modulus", "model"})
    edit.unset(table + key);
  edit.set(table + "law", "coulomb");
}

void make_frictionless(VariationEdit& edit, const std::string& table) {
  make_coulomb(edit, table);
  edit.unset(table + "mu");
  edit.set(table + "law", "frictionless");
}

void make_pressure(VariationEdit& edit, const std::string& table, const std::string& pressure) {
  for (const char* key : {"table_radius", "table_pressure"}) edit.unset(table + key);
  edit.set(table + "pressure", pressure);
}

std::set<std::string> tables_below(const SceneDocument& document, const std::string& table) {
  const std::string prefix = table + '.';
  std::set<std::string> names;
  for (auto at = document.values.lower_bound(prefix); at != document.values.end(); ++at) {
    if (!at->first.starts_with(prefix)) break;
    names.insert(at->first.substr(0, at->first.find('.', prefix.size())));
  }
  return names;
}

}  // namespace contensou
