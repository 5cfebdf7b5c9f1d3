#include "svg.hpp"

#include <cstdio>

namespace cli {
namespace {

std::string escaped(std::string_view text) {
  std::string shown;
  for (const char c : text) {
    if (c == '&') {
      shown += "&amp;";
    } else if (c == '<') {
      shown += "&lt;";
    } else if (c == '>') {
      shown += "&gt;";
    } else if (c == '"') {
      shown += "&quot;";
    } else if (static_cast<unsigned char>(c) >= 0x20) {
      shown += c;
    }
  }
  return shown;
}

/// ` name="1.25"`: six digits are enough for pixels.
std::string attribute(const char* name, double value) {
  char text[64];
  std::snprintf(text, sizeof text, " %s=\"%.6g\"", name, value);
  return text;
}

std::string attribute(const char* name, std::string_view value) {
  return std::string(" ") + name + "=\"" + std::string(value) + '"';
}

}  // namespace

Svg::Svg(double width, double height, std::string_view title) {
  drawing_ = "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\"" +
             attribute("width", width) + attribute("height", height) + " viewBox=\"0 0 " +
             std::to_string(static_cast<int>(width)) + ' ' + std::to_string(static_cast<int>(height)) +
             "\" font-family=\"sans-serif\">\n<title>" + escaped(title) + "</title>\n";
  rectangle(0, 0, width, height, "#ffffff");
}

void Svg::line(double x1, double y1, double x2, double y2, const Pen& pen) {
  drawing_ += "<line" + attribute("x1", x1) + attribute("y1", y1) + attribute("x2", x2) +
              attribute("y2", y2) + attribute("stroke", pen.colour) + attribute("stroke-width", pen.width) +
              "/>\n";
}

void Svg::rectangle(double x, double y, double width, double height, std::string_view colour) {
  drawing_ += "<rect" + attribute("x", x) + attribute("y", y) + attribute("width", width) +
              attribute("height", height) + attribute("fill", colour) + "/>\n";
}

void Svg::circle(double x, double y, double radius, std::string_view colour) {
  drawing_ += "<circle" + attribute("cx", x) + attribute("cy", y) + attribute("r", radius) +
              attribute("fill", colour) + "/>\n";
}

void Svg::text(double x, double y, std::string_view text, Align align, std::string_view colour, double size) {
  const char* anchor = align == Align::left ? "start" : align == Align::middle ? "middle" : "end";
  drawing_ += "<text" + attribute("x", x) + attribute("y", y) + attribute("text-anchor", anchor) +
              attribute("fill", colour) + attribute("font-size", size) + '>' + escaped(text) + "</text>\n";
}

}  // namespace cli
