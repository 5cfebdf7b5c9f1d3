#include "contensou/scene/body_columns.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "contensou/scene/between.hpp"

namespace contensou {
namespace {

/// At most so many bodies are told of one by one unless the scene asks for it.
constexpr std::size_t few_bodies = 4;

struct BodyColumn {
  const char* name;
  double (*value)(const BodyLayout&, std::size_t body, const Sample&);
};

double tilt(const BodyLayout& layout, std::size_t body, const Sample& at) {
  const Eigen::Vector3d axis = layout.orientation(body, at.t, at.q) * Eigen::Vector3d::UnitZ();
  return std::atan2(std::hypot(axis[0], axis[1]), axis[2]);
}

template <int axis>
double position(const BodyLayout& layout, std::size_t body, const Sample& at) {
  return layout.position(body, at.q)[axis];
}
template <int axis>
double velocity(const BodyLayout& layout, std::size_t body, const Sample& at) {
  return layout.velocity(body, at.u)[axis];
}
template <int axis>
double spin(const BodyLayout& layout, std::size_t body, const Sample& at) {
  return layout.spin(body, at.t, at.q, at.u)[axis];
}
/// Of (x, y, z, w), as Eigen keeps them.
template <int axis>
double attitude(const BodyLayout& layout, std::size_t body, const Sample& at) {
  return layout.orientation(body, at.t, at.q).coeffs()[axis];
}

constexpr std::array<BodyColumn, 15> columns_of_bodies{{
    {"x", position<0>},
    {"y", position<1>},
    {"z", position<2>},
    {"vx", velocity<0>},
    {"vy", velocity<1>},
    {"vz", velocity<2>},
    {"wx", spin<0>},
    {"wy", spin<1>},
    {"wz", spin<2>},
    {"speed", [](const BodyLayout& layout, std::size_t body,
                 const Sample& at) { return layout.velocity(body, at.u).norm(); }},
    {"tilt", tilt},
    {"qa", attitude<3>},
    {"qb", attitude<0>},
    {"qc", attitude<1>},
    {"qd", attitude<2>},
}};

struct WholeColumn {
  const char* name;
  double (*value)(const BodyLayout&, const Sample&);
};

double highest(const BodyLayout& layout, const Sample& at) {
  double z = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < layout.bodies(); ++i) z = std::max(z, layout.position(i, at.q)[2]);
  return z;
}

constexpr std::array<WholeColumn, 5> columns_of_all{{
    {"energy", [](const BodyLayout& layout,
                  const Sample& at) { return layout.kinetic_energy(at.u) + layout.potential_energy(at.q); }},
    {"kinetic", [](const BodyLayout& layout, const Sample& at) { return layout.kinetic_energy(at.u); }},
    {"potential", [](const BodyLayout& layout, const Sample& at) { return layout.potential_energy(at.q); }},
    {"highest", highest},
    {"contacts",
     [](const BodyLayout&, const Sample& at) {
       return static_cast<double>(std::count_if(at.modes.begin(), at.modes.end(),
                                                [](ContactMode m) { return m != ContactMode::open; }));
     }},
}};

/// gap_, slip_, spin_ and ratio_ of a contact.
struct ContactColumn {
  const char* prefix;
  bool needs_rows;  ///< else the gap
  double (*value)(double gap, const Eigen::Vector4d& gamma, double radius);
};

double slip(const Eigen::Vector4d& gamma) { return std::hypot(gamma[1], gamma[2]); }

constexpr std::array<ContactColumn, 4> columns_of_contacts{{
    {"gap_", false, [](double gap, const Eigen::Vector4d&, double) { return gap; }},
    {"slip_", true, [](double, const Eigen::Vector4d& gamma, double) { return slip(gamma); }},
    {"spin_", true, [](double, const Eigen::Vector4d& gamma, double radius) { return gamma[3] / radius; }},
    {"ratio_", true,
     [](double, const Eigen::Vector4d& gamma, double) { return slip(gamma) / std::abs(gamma[3]); }},
}};

template <class Columns>
auto find(const Columns& columns, std::string_view name) {
  return std::find_if(columns.begin(), columns.end(),
                      [&](const auto& column) { return column.name == name; });
}

const ContactColumn* contact_column(std::string_view name) {
  for (const ContactColumn& column : columns_of_contacts) {
    if (name.starts_with(column.prefix)) return &column;
  }
  return nullptr;
}

using Value = std::function<double(const BodyLayout&, const Sample&)>;

/// Of "BODY.COLUMN"; none where there is no such body or column.
Value body_value(const std::vector<BodyData>& bodies, const std::string& name) {
  const std::size_t dot = name.rfind('.');
  if (dot == std::string::npos) return {};
  const auto body = std::find_if(bodies.begin(), bodies.end(), [&](const BodyData& b) {
    return b.name.size() == dot && name.starts_with(b.name);
  });
  const auto* column = find(columns_of_bodies, std::string_view(name).substr(dot + 1));
  if (body == bodies.end() || column == columns_of_bodies.end()) return {};
  return [value = column->value, i = static_cast<std::size_t>(body - bodies.begin())](
             const BodyLayout& layout, const Sample& at) { return value(layout, i, at); };
}

/// Of "gap_CONTACT" and so on; none where there is no such contact, or it has no such rows.
Value contact_value(const std::shared_ptr<const MechanicalSystem>& system, const std::string& name) {
  const ContactColumn* column = contact_column(name);
  if (system == nullptr || column == nullptr) return {};
  const std::string contact = name.substr(std::string_view(column->prefix).size());
  const auto& contacts = system->contacts();
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (contacts[i].name != contact) continue;
    const int n = rows(contacts[i].friction);
    const bool slides = column->prefix == std::string_view("slip_");
    if (column->needs_rows && n < (slides ? 3 : 4)) return {};
    const auto kept = std::make_shared<ContactRows>(system->velocities());
    kept->velocity.setZero();
    return [=, value = column->value, needs_rows = column->needs_rows, radius = contacts[i].radius](
               const BodyLayout&, const Sample& at) {
      if (needs_rows) system->contact_rows(i, at.t, at.q, at.u, *kept);
      return value(needs_rows ? 0 : system->gap(i, at.t, at.q), kept->velocity, radius);
    };
  }
  return {};
}

Value whole_value(const std::string& name) {
  const auto* column = find(columns_of_all, name);
  if (column == columns_of_all.end()) return {};
  return column->value;
}

}  // namespace

std::vector<std::string> body_columns(const BodiesScene& scene) {
  std::vector<std::string> names;
  if (scene.data.bodies.size() <= few_bodies) {
    for (const BodyData& body : scene.data.bodies) {
      for (const char* column : {"x", "y", "z", "speed", "tilt"}) names.push_back(body.name + '.' + column);
    }
  } else {
    names.emplace_back("highest");
  }
  names.emplace_back("energy");
  return names;
}

bool has_body_column(const BodiesScene& scene, bool nscd, const std::string& column) {
  if (body_value(scene.data.bodies, column)) return true;
  if (whole_value(column)) return !(nscd && column == "contacts");
  const ContactColumn* kind = contact_column(column);
  if (nscd || kind == nullptr) return false;
  const std::string contact = column.substr(std::string_view(kind->prefix).size());
  const std::vector<PairName> pairs = pair_names(scene);
  return std::any_of(pairs.begin(), pairs.end(), [&](const PairName& pair) {
    const int needed = !kind->needs_rows ? 1 : kind->prefix == std::string_view("slip_") ? 3 : 4;
    return pair.name == contact && scene.contacts[pair.rule].rows() >= needed;
  });
}

std::string body_column_help() {
  return "BODY.x and so on, gap_CONTACT, slip_CONTACT, energy and others of docs/scenes.md";
}

DescribeMotion describe_bodies(std::shared_ptr<const BodiesData> data,
                               std::shared_ptr<const MechanicalSystem> system,
                               const std::vector<std::string>& names) {
  std::vector<Value> values;
  for (const std::string& name : names) {
    Value value = body_value(data->bodies, name);
    if (!value) value = whole_value(name);
    if (!value) value = contact_value(system, name);
    if (!value) throw std::invalid_argument("output: no column " + name + "; expected " + body_column_help());
    values.push_back(std::move(value));
  }
  return [data, layout = BodyLayout(*data), values = std::move(values)](const Sample& at,
                                                                        std::vector<double>& row) {
    for (const Value& value : values) row.push_back(value(layout, at));
  };
}

}  // namespace contensou
