#include "contensou/integrate/contact_dynamics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace contensou {

const AnyFriction& effective_friction(const SystemContact& contact) {
  static const AnyFriction none{NoFriction{}};
  return contact.mu > 0 ? contact.friction : none;
}

ContactDynamics::ContactDynamics(const MechanicalSystem& system)
    : system_(system),
      n_(system.coordinates()),
      f_(system.velocities()),
      works_(static_cast<Eigen::Index>(system.works().size())),
      drives_(system.driven()) {
  const std::size_t count = system.contacts().size();
  for (const SystemContact& contact : system.contacts()) {
    friction_.emplace_back(effective_friction(contact));
    mu_.push_back(contact.mu);
  }
  modes_.assign(count, ContactMode::open);
  border_.assign(count, Eigen::Vector3d::Zero());
  velocity_ = border_;
  rows_.assign(count, ContactRows(f_));
  worked_ = n_ + f_ + 2 * this->count();
  driven_ = worked_ + works_;
  force_.assign(count, Eigen::Vector4d::Zero());
  response_.assign(count, Eigen::VectorXd(f_));
  velocity_gradient_.assign(count, Eigen::MatrixXd(3, n_ + f_));
  closed_.reserve(count);
  constraints_.reserve(4 * count);
  moved_.resize(size());
  moved_rate_.resize(size());
  border_gradient_.resize(n_ + f_);
}

bool ContactDynamics::paradox() const {
  constexpr double nearly = 1e-6;
  return std::any_of(closed_.begin(), closed_.end(), [this](std::size_t i) {
    const auto normal = rows_[i].directions.col(0);
    return modes_[i] == ContactMode::slip &&
           normal.dot(response_[i]) < nearly * normal.dot(rows_[i].response.col(0));
  });
}

void ContactDynamics::set_modes(const std::vector<ContactMode>& modes) {
  modes_ = modes;
  closed_.clear();
  constraints_.clear();
  for (std::size_t i = 0; i < modes_.size(); ++i) {
    force_[i].setZero();
    if (modes_[i] == ContactMode::open) continue;
    closed_.push_back(i);
    constraints_.push_back({i, 0});
    if (modes_[i] != ContactMode::stick) continue;
    for (int k = 1; k <= friction_[i].dimension(); ++k) constraints_.push_back({i, k});
  }
  solver_.resize(static_cast<Eigen::Index>(constraints_.size()));
}

void ContactDynamics::derivative(double t, const Eigen::VectorXd& y, Eigen::VectorXd& dy) {
  ++evaluations_;
  evaluate(t, y, dy);
}

void ContactDynamics::evaluate(double t, const Eigen::VectorXd& y, Eigen::VectorXd& dy) {
  const auto q = y.head(n_);
  const auto u = y.segment(n_, f_);
  auto a = dy.segment(n_, f_);
  system_.coordinate_rates(q, u, dy.head(n_));
  system_.free_acceleration(t, q, u, a);
  dy.tail(size() - n_ - f_).setZero();
  if (works_ > 0) system_.powers(t, q, u, dy.segment(worked_, works_));
  if (closed_.empty()) return;

  for (const std::size_t i : closed_) {
    system_.contact_rows(i, t, q, u, rows_[i]);
    if (modes_[i] != ContactMode::slip) continue;
    if (!border_held_ && friction_[i].dimension() > 0)
      border_[i] = friction_[i].border(rows_[i].velocity.tail<3>());
    slip_response(i);
  }
  if (constraints_.size() == 1) {
    solve_one(a);
  } else {
    solve_all(a);
  }
  for (const std::size_t i : closed_) {
    if (drives_) dy[driven_ + static_cast<Eigen::Index>(i)] = driving_power(i, y);
    if (modes_[i] != ContactMode::slip) continue;
    const Eigen::Vector4d& gamma = rows_[i].velocity;
    const int dimension = friction_[i].dimension();
    const Eigen::Index at = n_ + f_ + 2 * static_cast<Eigen::Index>(i);
    if (dimension > 0) dy[at] = -(force_[i][1] * gamma[1] + force_[i][2] * gamma[2]);
    if (dimension > 2) dy[at + 1] = -force_[i][3] * gamma[3];
  }
}

void ContactDynamics::slip_response(std::size_t i) {
  const ContactRows& rows = rows_[i];
  Eigen::VectorXd& response = response_[i];
  response = rows.response.col(0);
  for (int k = 1; k <= friction_[i].dimension(); ++k)
    response -= (mu_[i] * border_[i][k - 1]) * rows.response.col(k);
}

/// One closed contact that slips (or has no friction).
void ContactDynamics::solve_one(Eigen::Ref<Eigen::VectorXd> a) {
  const std::size_t i = closed_.front();
  const ContactRows& rows = rows_[i];
  const double inverse_mass = rows.directions.col(0).dot(response_[i]);
  const double normal = -(rows.directions.col(0).dot(a) + rows.drift[0]) / inverse_mass;
  a += normal * response_[i];
  force_[i][0] = normal;
  force_[i].tail<3>() = (-mu_[i] * normal) * border_[i];
}

void ContactDynamics::solve_all(Eigen::Ref<Eigen::VectorXd> a) {
  const auto m = static_cast<Eigen::Index>(constraints_.size());
  const auto response = [&](const Constraint& c) -> Eigen::Ref<const Eigen::VectorXd> {
    if (c.row == 0 && modes_[c.contact] == ContactMode::slip) return response_[c.contact];
    return rows_[c.contact].response.col(c.row);
  };
  for (Eigen::Index i = 0; i < m; ++i) {
    const Constraint& c = constraints_[static_cast<std::size_t>(i)];
    const auto direction = rows_[c.contact].directions.col(c.row);
    solver_.side[i] = -(direction.dot(a) + rows_[c.contact].drift[c.row]);
    for (Eigen::Index j = 0; j < m; ++j)
      solver_.matrix(i, j) = direction.dot(response(constraints_[static_cast<std::size_t>(j)]));
  }
  const Eigen::VectorXd& solution = solver_.solve();
  for (const std::size_t i : closed_) force_[i].setZero();
  for (Eigen::Index j = 0; j < m; ++j) {
    const Constraint& c = constraints_[static_cast<std::size_t>(j)];
    a += solution[j] * response(c);
    force_[c.contact][c.row] = solution[j];
    if (c.row == 0 && modes_[c.contact] == ContactMode::slip)
      force_[c.contact].tail<3>() = (-mu_[c.contact] * solution[j]) * border_[c.contact];
  }
}

double ContactDynamics::driving_power(std::size_t i, const Eigen::VectorXd& y) const {
  double power = 0;
  for (int k = 0; k <= friction_[i].dimension(); ++k)
    power -= force_[i][k] * rows_[i].given(k, y.segment(n_, f_));
  return power;
}

void ContactDynamics::read_energy(const Eigen::VectorXd& y, std::vector<Dissipation>& dissipated,
                                  std::vector<double>& work) const {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    dissipated[i].sliding = y[n_ + f_ + 2 * k];
    dissipated[i].drilling = y[n_ + f_ + 2 * k + 1];
    if (drives_) dissipated[i].driven += y[driven_ + k];
  }
  work.assign(y.data() + worked_, y.data() + driven_);
}

Eigen::Vector4d ContactDynamics::contact_acceleration(std::size_t i, const Eigen::VectorXd& dy) const {
  const ContactRows& rows = rows_[i];
  Eigen::Vector4d rate = Eigen::Vector4d::Zero();
  for (int k = 0; k <= friction_[i].dimension(); ++k)
    rate[k] = rows.directions.col(k).dot(dy.segment(n_, f_)) + rows.drift[k];
  return rate;
}

double ContactDynamics::relaxation_rate() const {
  double fastest = 0;
  for (const std::size_t i : closed_) {
    const int dimension = friction_[i].dimension();
    if (modes_[i] != ContactMode::slip || dimension == 0) continue;
    if (rows_[i].velocity.segment(1, dimension).isZero(0)) continue;  // at rest: no rate at all
    const Eigen::Matrix3d law = friction_[i].derivative(rows_[i].velocity.tail<3>());
    // ‖W_FF ∂x̂/∂γ_F‖_∞, no less than the largest eigenvalue.
    for (int k = 0; k < dimension; ++k) {
      double sum = 0;
      for (int l = 0; l < dimension; ++l) {
        double entry = 0;
        for (int j = 0; j < dimension; ++j)
          entry += rows_[i].directions.col(k + 1).dot(rows_[i].response.col(j + 1)) * law(j, l);
        sum += std::abs(entry);
      }
      fastest = std::max(fastest, mu_[i] * std::abs(force_[i][0]) * sum);
    }
  }
  return fastest;
}

void ContactDynamics::jacobian(double t, const Eigen::VectorXd& y, const Eigen::VectorXd& rate,
                               Eigen::MatrixXd& jacobian) {
  static const double increment = std::sqrt(std::numeric_limits<double>::epsilon());
  evaluate(t, y, moved_rate_);
  for (const std::size_t i : closed_) velocity_[i] = rows_[i].velocity.tail<3>();

  border_held_ = true;
  moved_ = y;
  for (Eigen::Index j = 0; j < n_ + f_; ++j) {
    moved_[j] = y[j] + increment * (1 + std::abs(y[j]));
    const double h = moved_[j] - y[j];
    derivative(t, moved_, moved_rate_);
    jacobian.col(j) = (moved_rate_ - rate) / h;
    moved_[j] = y[j];
    for (const std::size_t i : closed_)
      velocity_gradient_[i].col(j) = (rows_[i].velocity.tail<3>() - velocity_[i]) / h;
  }
  for (const std::size_t i : closed_) {
    const int dimension = friction_[i].dimension();
    if (modes_[i] != ContactMode::slip || dimension == 0) continue;
    const Eigen::Matrix3d law = friction_[i].derivative(velocity_[i]);
    const Eigen::Vector3d held = border_[i];
    for (int k = 0; k < dimension; ++k) {
      border_[i] = held;
      border_[i][k] += increment;
      derivative(t, y, moved_rate_);
      moved_rate_ -= rate;
      moved_rate_ /= increment;
      border_gradient_.noalias() = law.row(k) * velocity_gradient_[i];
      jacobian.noalias() += moved_rate_ * border_gradient_;
    }
    border_[i] = held;
  }
  border_held_ = false;
}

}  // namespace contensou
