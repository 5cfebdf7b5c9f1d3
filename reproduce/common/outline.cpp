#include "outline.hpp"

#include <cmath>

#include "curves.hpp"

namespace reproduce {

using contensou::Table;
using Eigen::Vector2d;

Table outline_table(const std::string& figure, const std::string& what, const std::string& units,
                    const std::string& source) {
  return curve_table(figure, what + ": outlines and arcs", units, "none; " + source, {"curve", "x", "y"});
}

Table line_table(const std::string& figure, const std::string& what, const std::string& units,
                 const std::string& source) {
  return curve_table(figure, what + ": straight lines and arrows", units, "none; " + source,
                     {"line", "x", "y", "dx", "dy"});
}

Table place_table(const std::string& figure, const std::string& what, const std::string& units,
                  const std::string& source) {
  return curve_table(figure, what + ": points", units, "none; " + source, {"point", "x", "y"});
}

void add_arc(Table& curves, const char* name, const Vector2d& centre, double radius, double from, double to,
             int pieces) {
  for (int k = 0; k <= pieces; ++k) {
    const double angle = from + (to - from) * k / pieces;
    add_vertex(curves, name, {centre.x() + radius * std::cos(angle), centre.y() + radius * std::sin(angle)});
  }
}

void add_vertex(Table& curves, const char* name, const Vector2d& at) { curves.add({name, at.x(), at.y()}); }

void add_line(Table& lines, const char* name, const Vector2d& from, const Vector2d& to) {
  lines.add({name, from.x(), from.y(), to.x() - from.x(), to.y() - from.y()});
}

void add_place(Table& places, const char* name, const Vector2d& at) { places.add({name, at.x(), at.y()}); }

}  // namespace reproduce
