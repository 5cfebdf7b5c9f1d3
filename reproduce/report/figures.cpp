#include "figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "html.hpp"

namespace report {
namespace {

namespace fs = std::filesystem;

// The files of `folder` that belong to a figure, "fig03" -> fig03a.svg, fig03b.svg, in order.
std::vector<fs::path> files_of(const fs::path& folder, const std::string& figure,
                               const std::string& extension) {
  std::vector<fs::path> files;
  if (!fs::is_directory(folder)) return files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().filename().string().starts_with(figure) && entry.path().extension() == extension) {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<std::string> text_lines(const fs::path& readme) {
  std::istringstream in(read_text(readme));
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) {
    if (!line.empty()) lines.push_back(line);
  }
  if (lines.size() != 3) throw std::runtime_error(readme.string() + ": expected three lines of text");
  return lines;
}

// The names of the figure's tables in `html` become links that carry the table with them.
std::string with_tables_attached(std::string html, const fs::path& data, const std::string& figure) {
  for (const fs::path& file : files_of(data, figure, ".tsv")) {
    const std::string name = file.filename().string();
    const std::size_t at = html.find(name);
    if (at == std::string::npos) throw std::runtime_error(figure + "/README.md does not name " + name);
    html.replace(
        at, name.size(),
        fmt::format(
            "<a download=\"{0}\" href=\"data:text/tab-separated-values;charset=utf-8;base64,{1}\">{0}</a>",
            name, base64(read_text(file))));
  }
  return html;
}

std::string one_figure(const fs::path& source, const fs::path& report) {
  const std::string name = source.filename().string();
  const auto text = text_lines(source / "README.md");
  std::string html = fmt::format("<figure id=\"{}\"><div class=\"panels\">\n", name);
  const auto drawings = files_of(report / "figures", name, ".svg");
  for (const fs::path& drawing : drawings) {
    const std::string panel = drawing.stem().string();
    const std::string letter = panel.substr(name.size());
    html +=
        fmt::format("<div class=\"panel\">{}{}</div>\n", inline_svg(drawing, panel, text[0]),
                    letter.empty() ? "" : fmt::format("<div class=\"letter\">({})</div>", escape(letter)));
  }
  if (drawings.empty()) html += "<p class=\"missing\">Not drawn yet.</p>\n";
  html += fmt::format("</div><figcaption><p>{}</p><p class=\"make\">{}</p><p class=\"make\">{}</p>",
                      prose(text[0]), prose(text[1]),
                      with_tables_attached(prose(text[2]), report / "data", name));
  return html + "</figcaption></figure>\n";
}

}  // namespace

std::string read_text(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::runtime_error(file.string() + ": cannot be read");
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string inline_svg(const fs::path& file, const std::string& prefix, const std::string& title) {
  std::string svg = read_text(file);
  const std::size_t begin = svg.find("<svg");
  if (begin == std::string::npos) throw std::runtime_error(file.string() + ": no SVG in it");
  svg.erase(0, begin);
  // gnuplot gives the same ids to the parts of every drawing.
  static const std::regex ids(R"((\sid=["'])([^"']+))"), references(R"((href=["']#)([^"']+))"),
      urls(R"((url\(#)([^)]+))");
  for (const std::regex& pattern : {ids, references, urls}) {
    svg = std::regex_replace(svg, pattern, "$1" + prefix + "-$2");
  }
  // Its own <title> would show as a tooltip "Gnuplot".
  static const std::regex own_title(R"(<title>[^<]*</title>\s*|<desc>[^<]*</desc>\s*)");
  svg = std::regex_replace(svg, own_title, "");
  svg.insert(4, fmt::format(" role=\"img\" aria-label=\"{}\"", escape(title)));
  return svg;
}

std::string figures(const fs::path& sources, const fs::path& report) {
  std::vector<fs::path> folders;
  for (const auto& entry : fs::directory_iterator(sources)) {
    if (entry.is_directory() && entry.path().filename().string().starts_with("fig"))
      folders.push_back(entry.path());
  }
  std::sort(folders.begin(), folders.end());
  std::string html;
  for (const fs::path& folder : folders) html += one_figure(folder, report);
  return html;
}

}  // namespace report
