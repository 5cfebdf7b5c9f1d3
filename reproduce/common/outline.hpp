#pragma once

#include <Eigen/Core>
#include <string>

#include "contensou/output/table.hpp"

/// Drawings without a law in them: tables of outlines (columns curve, x, y), of straight lines and arrows
/// (line, x, y, dx, dy) and of places (point, x, y).
namespace reproduce {

contensou::Table outline_table(const std::string& figure, const std::string& what, const std::string& units,
                               const std::string& source);
contensou::Table line_table(const std::string& figure, const std::string& what, const std::string& units,
                            const std::string& source);
contensou::Table place_table(const std::string& figure, const std::string& what, const std::string& units,
                             const std::string& source);

/// Appends an arc of a circle, angles in rad from the x axis, in `pieces` chords.
void add_arc(contensou::Table& curves, const char* name, const Eigen::Vector2d& centre, double radius,
             double from, double to, int pieces = 96);
void add_vertex(contensou::Table& curves, const char* name, const Eigen::Vector2d& at);
void add_line(contensou::Table& lines, const char* name, const Eigen::Vector2d& from,
              const Eigen::Vector2d& to);
void add_place(contensou::Table& places, const char* name, const Eigen::Vector2d& at);

}  // namespace reproduce
