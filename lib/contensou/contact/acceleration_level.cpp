#include "contensou/contact/acceleration_level.hpp"

#include <stdexcept>
#include <string>
#include <type_traits>

#include "contensou/contact/blocks.hpp"

namespace contensou {
namespace {

const AnyFriction& no_friction() {
  static const AnyFriction friction{NoFriction{}};
  return friction;
}

/// x̂: the border point with outward normal γ_F, in units of the size.
Eigen::Vector2d border(const FrictionDisk&, const Eigen::Vector2d& gamma) { return gamma.stableNormalized(); }
template <class Plate>
Eigen::Vector3d border(const FrictionBall<Plate>& ball, const Eigen::Vector3d& gamma) {
  return ball.boundary_point(1, gamma);
}

/// A column of the expansion: what one reduced row means for the rows from `first` on.
struct Column {
  Eigen::Index first;
  Eigen::Matrix<double, 4, 1> entries;
  int count;
};

}  // namespace

AccelerationLevel::AccelerationLevel(const ContactProblem& full, const Eigen::VectorXd& velocity) {
  require_valid(full);
  const Eigen::Index n = full.rows();
  if (velocity.size() != n || !velocity.allFinite()) {
    throw std::invalid_argument("acceleration level: velocity needs " + std::to_string(n) +
                                " finite entries");
  }
  std::vector<Column> columns;
  std::size_t group_index = 0;
  for_each_group(full, [&]<class Domain>(const TypedGroup<Domain>& group) {
    constexpr int dimension = Domain::dimension;
    const AnyFriction* const friction = full.groups[group_index++].friction;
    if constexpr (std::is_same_v<Domain, FrictionCylinder>) {
      throw std::invalid_argument(
          "acceleration level: sliding and drilling friction apart may stick one without the other, expected "
          "friction that does not");
    } else if constexpr (dimension == 0) {
      problem_.groups.push_back({friction, std::vector<double>(group.mu, group.mu + group.count)});
      for (Eigen::Index i = 0; i < group.count; ++i) columns.push_back({group.row(i), {1, 0, 0, 0}, 1});
    } else {
      ContactGroup sticking{friction, {}};
      ContactGroup sliding{&no_friction(), {}};
      std::vector<Column> sliding_columns;
      for (Eigen::Index i = 0; i < group.count; ++i) {
        const Eigen::Matrix<double, dimension, 1> gamma =
            group.segment(velocity, i).template tail<dimension>();
        if (gamma.isZero(0)) {
          sticking.mu.push_back(group.mu[i]);
          for (int k = 0; k <= dimension; ++k) columns.push_back({group.row(i) + k, {1, 0, 0, 0}, 1});
        } else {
          sliding.mu.push_back(group.mu[i]);
          Column column{group.row(i), {1, 0, 0, 0}, 1 + dimension};
          column.entries.template segment<dimension>(1) = -group.mu[i] * border(group.domain, gamma);
          sliding_columns.push_back(column);
        }
      }
      problem_.groups.push_back(sticking);
      problem_.groups.push_back(sliding);
      columns.insert(columns.end(), sliding_columns.begin(), sliding_columns.end());
    }
  });

  const auto reduced = static_cast<Eigen::Index>(columns.size());
  expansion_.setZero(n, reduced);
  for (Eigen::Index j = 0; j < reduced; ++j) {
    const Column& column = columns[static_cast<std::size_t>(j)];
    expansion_.col(j).segment(column.first, column.count) = column.entries.head(column.count);
    rows_.push_back(column.first);
  }
  const Eigen::MatrixXd response = full.delassus * expansion_;
  problem_.delassus = response(rows_, Eigen::all);
  problem_.free_velocity = full.free_velocity(rows_);
  for (Eigen::Index j = 0; j < reduced; ++j) {
    const bool slides = columns[static_cast<std::size_t>(j)].count > 1;
    paradox_ = paradox_ || (slides && problem_.delassus(j, j) <= 0);
  }
}

}  // namespace contensou
