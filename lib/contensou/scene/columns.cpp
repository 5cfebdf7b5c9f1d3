#include "contensou/scene/columns.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "contensou/scene/body_columns.hpp"

namespace contensou {
namespace {

/// A column of the tippe-top: its name, and its value.
struct TopColumn {
  const char* name;
  double (*value)(const TippeTopModel&, const Sample&);
};

constexpr std::array<TopColumn, 13> top_columns{{
    {"theta", [](const TippeTopModel& top, const Sample& at) { return top.inclination(at.q); }},
    {"z_s", [](const TippeTopModel& top, const Sample& at) { return top.height(at.q); }},
    {"gap_body", [](const TippeTopModel& top, const Sample& at) { return top.gap(0, at.t, at.q); }},
    {"gap_tip", [](const TippeTopModel& top, const Sample& at) { return top.gap(1, at.t, at.q); }},
    {"energy", [](const TippeTopModel& top,
                  const Sample& at) { return top.kinetic_energy(at.q, at.u) + top.potential_energy(at.q); }},
    {"omega_z", [](const TippeTopModel& top, const Sample& at) { return top.spin(at.q, at.u)[2]; }},
    {"omega_x", [](const TippeTopModel& top, const Sample& at) { return top.spin(at.q, at.u)[0]; }},
    {"omega_y", [](const TippeTopModel& top, const Sample& at) { return top.spin(at.q, at.u)[1]; }},
    {"x_s", [](const TippeTopModel&, const Sample& at) { return at.q[0]; }},
    {"y_s", [](const TippeTopModel&, const Sample& at) { return at.q[1]; }},
    {"axis_x", [](const TippeTopModel& top, const Sample& at) { return top.axis(at.q)[0]; }},
    {"axis_y", [](const TippeTopModel& top, const Sample& at) { return top.axis(at.q)[1]; }},
    {"axis_z", [](const TippeTopModel& top, const Sample& at) { return top.axis(at.q)[2]; }},
}};

const TopColumn* top_column(const std::string& name) {
  const auto* found = std::find_if(top_columns.begin(), top_columns.end(),
                                   [&](const TopColumn& column) { return column.name == name; });
  return found == top_columns.end() ? nullptr : found;
}

}  // namespace

DescribeMotion describe_tippe_top(std::shared_ptr<const TippeTopModel> top,
                                  const std::vector<std::string>& names) {
  std::vector<const TopColumn*> chosen;
  for (const std::string& name : names) {
    chosen.push_back(top_column(name));
    if (chosen.back() == nullptr) throw std::invalid_argument("a tippe-top has no column " + name);
  }
  return [top = std::move(top), chosen = std::move(chosen)](const Sample& at, std::vector<double>& row) {
    for (const TopColumn* column : chosen) row.push_back(column->value(*top, at));
  };
}

std::vector<std::string> columns(const Scene& scene) {
  std::vector<std::string> names = scene.columns;
  if (names.empty() && std::holds_alternative<TippeTopScene>(scene.system)) {
    for (const TopColumn& column : top_columns) names.emplace_back(column.name);
  } else if (names.empty()) {
    names = body_columns(std::get<BodiesScene>(scene.system));
  }
  for (const MeasureScene& measure : scene.measures) {
    if (!measure.column.empty() && std::find(names.begin(), names.end(), measure.column) == names.end())
      names.push_back(measure.column);
  }
  return names;
}

bool has_column(const Scene& scene, const std::string& column) {
  if (std::holds_alternative<TippeTopScene>(scene.system)) return top_column(column) != nullptr;
  return has_body_column(std::get<BodiesScene>(scene.system), scene.integrator.method == Method::nscd,
                         column);
}

std::string column_help(const Scene& scene) {
  if (!std::holds_alternative<TippeTopScene>(scene.system)) return body_column_help();
  std::string names = "one of";
  for (const TopColumn& column : top_columns) names += std::string(" ") + column.name;
  return names;
}

}  // namespace contensou
