#pragma once

#include <string>
#include <string_view>

namespace cli {

/// A drawing in SVG 1.1 on white, in the colours of the report. Lengths are pixels, y downwards.
class Svg {
 public:
  Svg(double width, double height, std::string_view title);

  enum class Align { left, middle, right };
  struct Pen {
    std::string_view colour;
    double width = 1;
  };
  void line(double x1, double y1, double x2, double y2, const Pen& pen);
  void rectangle(double x, double y, double width, double height, std::string_view colour);
  void circle(double x, double y, double radius, std::string_view colour);
  void text(double x, double y, std::string_view text, Align align = Align::left,
            std::string_view colour = ink, double size = 13);
  /// The whole drawing.
  std::string finished() const { return drawing_ + "</svg>\n"; }

  static constexpr std::string_view ink = "#1a1a1a", grey = "#7a7a7a", light = "#dedede", blue = "#0072b2",
                                    vermilion = "#d55e00", green = "#007a5a", pale = "#f4f6f8";

 private:
  std::string drawing_;
};

}  // namespace cli
