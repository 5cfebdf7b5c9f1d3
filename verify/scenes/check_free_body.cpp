#include <Eigen/Geometry>
#include <cmath>
#include <string>

#include "checks.hpp"
#include "free_body.hpp"
#include "shipped.hpp"
#include "worst.hpp"

namespace verify::answers {
namespace {

book::Whole whole(const Shipped& run, std::size_t row) {
  const auto at = [&](const char* column) { return run.at(std::string("book.") + column, row); };
  const Eigen::Matrix3d axes = Eigen::Quaterniond(at("qa"), at("qb"), at("qc"), at("qd")).toRotationMatrix();
  book::Whole all;
  all << Eigen::Vector3d(at("wx"), at("wy"), at("wz")) / book::omega.norm(), axes.col(0), axes.col(1),
      axes.col(2);
  return all;
}

}  // namespace

void check_free_body(Sheet& sheet) {
  const std::string file = "free_body", by = "Jacobi's elliptic functions";
  const book::Motion motion = book::thrown();
  const Shipped run(file, {accurate});
  double low = 0, high = 1.5;
  for (int k = 0; k < 60; ++k) {
    const double middle = (low + high) / 2;
    (book::tilt(motion, middle) < std::acos(0.0) ? low : high) = middle;
  }
  // Rows are joined by lines: off by h²/8 of the second over the first derivative, at most about ω²/ω.
  sheet.compare({"free.over", file, "it first lies on its side at [s]", by, low, run.measured("turns_over"),
                 0, book::interval * book::interval * book::omega.norm() / 8});
  Worst worst;
  for (std::size_t i = 0; i < run.rows(); i += 50) {
    const double t = run.at("t", i);
    const double grown = 1 + book::spread([t](const book::Motion& off) { return book::whole(off, t); });
    worst.add((whole(run, i) - book::whole(motion, t)).norm() / (grown * (run.steps_error() + oracle_error)));
  }
  sheet.add({"free.motion", file,
             "spin and attitude all the way, largest error over what steps can add up to", by, 0,
             worst.value(), worst.value(), 1});
  const auto& books = run.outcome().energy;
  sheet.compare({"free.energy", file, "energy in the end over that at the start", "1", 1,
                 books.final / books.initial, 0, 2 * run.steps_error()});
}

}  // namespace verify::answers
