#include "contensou/granular/contact_set.hpp"

#include <algorithm>
#include <cmath>

#include "contensou/contact/blocks.hpp"
#include "contensou/system/contact_geometry.hpp"

namespace contensou {
namespace {

using Eigen::Vector3d;

/// n, and where there is friction two axes across it.
template <int directions>
Eigen::Matrix<double, 3, directions> axes_of(const Vector3d& n) {
  if constexpr (directions == 1) {
    return n;
  } else {
    return contact_axes(n);
  }
}

/// As it is of spheres about centres of mass.
template <int rows>
bool is_plain(const Eigen::Matrix<double, rows, rows>& w) {
  if constexpr (rows < 3) {
    return true;
  } else {
    constexpr double rounding = 0x1p-48;
    const double small = rounding * w.diagonal().minCoeff();
    const Eigen::Matrix<double, rows, rows> beside =
        w - Eigen::Matrix<double, rows, rows>(w.diagonal().asDiagonal());
    return beside.cwiseAbs().maxCoeff() <= small && std::abs(w(1, 1) - w(2, 2)) <= small;
  }
}

/// R under the load of the last step; of a pair that did not touch then, under what stops it alone.
double radius_under_load(const SystemContact& rule, const NearPair& pair, const PairList& list,
                         const Approach& approach, double normal_block, double target, double dt) {
  LoadRadius law = *rule.load_radius;
  const double r = list.shapes()[pair.first].radius;
  law.relative_radius = r;
  if (!list.is_plane(pair)) {
    const double other = list.shapes()[pair.second].radius;
    law.relative_radius = r * other / (r + other);
  }
  double impulse = pair.impulse.dot(approach.normal);
  if (!(impulse > 0)) impulse = (target - approach.free) / normal_block;
  return law.at(std::max(impulse, 0.0) / dt);
}

}  // namespace

void ContactSet::clear() {
  order_.clear();
  runs_.clear();
  rows_ = 0;
  largest_run_ = 0;
  std::apply([](auto&... blocks) { (blocks.clear(), ...); }, blocks_);
}

void ContactSet::sort(const PairList& list) {
  colouring_.clear(data_.bodies.size());
  for (std::uint32_t k = 0; k < list.pairs().size(); ++k) {
    const NearPair& pair = list.pairs()[k];
    if (!pair.chosen) continue;
    const auto [first, second] = list.bodies(pair);
    const bool as_point = !pair.exact && contensou::rows(data_.rules[pair.rule].friction) == 4;
    order_.push_back({colouring_.next(first, second), pair.rule, as_point, k});
  }
  std::sort(order_.begin(), order_.end(), [](const Order& a, const Order& b) {
    return std::tie(a.colour, a.rule, a.as_point, a.pair) < std::tie(b.colour, b.rule, b.as_point, b.pair);
  });
}

void ContactSet::build(const PairList& list, const std::vector<Approach>& approach,
                       const std::vector<Mobility>& mobility, double dt) {
  clear();
  sort(list);
  for (auto begin = order_.begin(); begin != order_.end();) {
    const auto end = std::find_if(begin, order_.end(), [&](const Order& o) {
      return o.colour != begin->colour || o.rule != begin->rule || o.as_point != begin->as_point;
    });
    const SystemContact& rule = data_.rules[begin->rule];
    const AnyFriction& friction = begin->as_point ? point_ : rule.friction;
    std::visit(
        [&]<class Domain>(const Domain&) {
          constexpr int rows = 1 + Domain::dimension;
          auto& blocks = std::get<std::vector<ContactBlock<rows>>>(blocks_);
          runs_.push_back({&friction, rule.mu, begin->rule, begin->colour, begin->as_point, blocks.size(),
                           static_cast<std::size_t>(end - begin)});
          rows_ += rows * static_cast<Eigen::Index>(end - begin);
          largest_run_ = std::max(largest_run_, static_cast<std::size_t>(end - begin));
          for (auto it = begin; it != end; ++it) {
            const NearPair& pair = list.pairs()[it->pair];
            const Approach& a = approach[it->pair];
            ContactBlock<rows>& c = blocks.emplace_back();
            c.pair = it->pair;
            std::tie(c.first, c.second) = list.bodies(pair);
            c.axes = axes_of<ContactBlock<rows>::directions>(a.normal);
            c.arm = a.arm;
            c.other = a.other;
            c.target = normal_target(a, rule.restitution, dt);
            c.radius = rule.radius;
            c.w = own_block(c, mobility);
            if constexpr (rows == 4) {
              if (rule.load_radius) {
                c.radius = radius_under_load(rule, pair, list, a, c.w(0, 0), c.target, dt);
                c.w = own_block(c, mobility);
              }
              c.impulse[3] = pair.drilling;
            }
            c.step = natural_step(row_sum_norm(c.w), 1);
            c.weight = std::sqrt(c.step);
            c.plain = is_plain(c.w);
            c.impulse.template head<ContactBlock<rows>::directions>() = c.axes.transpose() * pair.impulse;
            c.impulse[0] = std::max(c.impulse[0], 0.0);
          }
        },
        friction);
    begin = end;
  }
}

void ContactSet::store(PairList& list) {
  for (NearPair& pair : list.pairs()) {
    pair.impulse.setZero();
    pair.drilling = 0;
  }
  for_each_run([&](const auto&, const Run&, auto blocks) {
    for (const auto& c : blocks) {
      list.pairs()[c.pair].impulse =
          c.axes * c.impulse.template head<std::decay_t<decltype(c)>::directions>();
      if constexpr (std::decay_t<decltype(c)>::Vector::RowsAtCompileTime == 4)
        list.pairs()[c.pair].drilling = c.impulse[3];
    }
  });
}

}  // namespace contensou
