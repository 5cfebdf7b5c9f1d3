#include "html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "number.hpp"

namespace report {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_beyond_ascii(char c) { return static_cast<unsigned char>(c) >= 0x80; }
bool is_word(char c) { return is_letter(c) || is_digit(c) || c == '_' || is_beyond_ascii(c); }

// True if the underscore at i hangs an index on a symbol
// (λ_N, P_F), and is not part of a name (fig03b_printed.tsv).
bool begins_index(std::string_view text, std::size_t i) {
  if (i == 0 || i + 1 >= text.size() || !is_word(text[i + 1]) || text[i + 1] == '_') return false;
  const char base = text[i - 1];
  if (is_beyond_ascii(base)) return true;
  return is_letter(base) && (i == 1 || !is_word(text[i - 2]) || is_beyond_ascii(text[i - 2]));
}

std::size_t end_of_index(std::string_view text, std::size_t i) {
  while (i < text.size() && (is_letter(text[i]) || is_digit(text[i]))) ++i;
  if (i < text.size() && is_beyond_ascii(text[i]) && text[i - 1] == '_') {
    do ++i;
    while (i < text.size() && (text[i] & 0xC0) == 0x80);  // the rest of one UTF-8 character
  }
  return i;
}

std::string with_indices(std::string_view text) {
  std::string html;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '_' && begins_index(text, i)) {
      const std::size_t end = end_of_index(text, i + 1);
      html += fmt::format("<sub>{}</sub>", escape(text.substr(i + 1, end - i - 1)));
      i = end - 1;
    } else {
      html += escape(text.substr(i, 1));
    }
  }
  return html;
}

std::string kind_of_verdict(std::string_view verdict) {
  if (verdict == "holds") return "good";
  if (verdict == "fails" || verdict == "holds unexpectedly" || verdict == "wrong") return "bad";
  if (verdict == "not checkable") return "open";
  return "warn";
}

// Where in u something is: with all digits.
bool is_place(std::string_view column) { return column == "worst_u" || column.starts_with("where_"); }

}  // namespace

std::string escape(std::string_view text) {
  std::string html;
  html.reserve(text.size());
  for (const char c : text) {
    switch (c) {
      case '&':
        html += "&amp;";
        break;
      case '<':
        html += "&lt;";
        break;
      case '>':
        html += "&gt;";
        break;
      case '"':
        html += "&quot;";
        break;
      case '\'':
        html += "&#39;";
        break;
      default:
        html += c;
    }
  }
  return html;
}

std::string prose(std::string_view text) {
  std::string html;
  bool code = false;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t tick = std::min(text.find('`', start), text.size());
    const std::string_view piece = text.substr(start, tick - start);
    html += code ? fmt::format("<code>{}</code>", escape(piece)) : with_indices(piece);
    code = !code;
    start = tick + 1;
  }
  return html;
}

std::string cell(std::string_view text) {
  const auto x = number(text);
  if (!x) return prose(text);
  const std::string few = rounded(*x);
  return few == "1" ? unrounded(text) : few;
}

std::string table(const contensou::Table& table, std::string_view id, std::string_view title, bool open) {
  const auto has = [&table](const char* name) {
    return std::find(table.columns.begin(), table.columns.end(), name) != table.columns.end();
  };
  const bool judged = has("verdict");                              // mostly text: cards on a narrow screen
  const bool linked = has("id") && table.columns.front() == "id";  // rows to link to
  std::string html = fmt::format(
      "<details class=\"table{}\" id=\"{}\"{}><summary>{} <span class=\"count\">{} rows</span></summary>\n",
      judged ? " cards" : "", escape(id), open ? " open" : "", prose(title), table.rows.size());
  html += "<p class=\"note\">";
  for (const std::string& comment : table.comments) html += prose(comment) + "<br>\n";
  html += "</p>\n";
  constexpr std::size_t seen_at_once = 12;  // rows that need no filter
  if (table.rows.size() > seen_at_once) {
    html += fmt::format(
        "<p class=\"tools\"><input type=\"search\" placeholder=\"filter\" aria-label=\"filter {}\"></p>\n",
        escape(title));
  }
  html += "<div class=\"scroll\" tabindex=\"0\"><table><thead><tr>";
  for (std::size_t j = 0; j < table.columns.size(); ++j) {
    const bool numeric = !table.rows.empty() && number(table.rows.front()[j]);
    html += fmt::format("<th{}><button type=\"button\">{}</button></th>", numeric ? " class=\"n\"" : "",
                        escape(table.columns[j]));
  }
  html += "</tr></thead><tbody>\n";
  for (const auto& row : table.rows) {
    html += linked ? fmt::format("<tr id=\"row-{}\">", escape(row.front())) : "<tr>";
    for (std::size_t j = 0; j < row.size(); ++j) {
      const std::string& column = table.columns[j];
      const std::string name = judged ? fmt::format(" data-c=\"{}\"", escape(column)) : "";
      if (column == "verdict") {
        html += fmt::format("<td{}><span class=\"chip {}\">{}</span></td>", name, kind_of_verdict(row[j]),
                            escape(row[j]));
      } else if (number(row[j])) {
        html += fmt::format("<td{0} class=\"n\" data-n=\"{1}\" title=\"{1}\">{2}</td>", name, escape(row[j]),
                            is_place(column) ? unrounded(row[j]) : cell(row[j]));
      } else {
        html += fmt::format("<td{}>{}</td>", name, prose(row[j]));
      }
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table></div></details>\n";
}

std::string base64(std::string_view bytes) {
  static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned group = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      group = group << 8 | (i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0U);
    }
    for (std::size_t j = 0; j < 4; ++j) {
      text += i + j <= bytes.size() ? digits[group >> (18 - 6 * j) & 63U] : '=';
    }
  }
  return text;
}

}  // namespace report
