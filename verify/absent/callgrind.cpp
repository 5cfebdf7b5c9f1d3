#include "callgrind.hpp"

#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

namespace verify::absent {
namespace {

namespace fs = std::filesystem;

std::string quoted(const std::string& argument) {
  std::string shown = "'";
  for (const char c : argument) shown += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return shown + '\'';
}

std::int64_t whole_number(std::string_view text) {
  std::int64_t number = 0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

/// Functions are named once, "fn=(12) name", and then by number, "fn=(12)".
class Names {
 public:
  const std::string& operator()(std::string_view text) {
    const std::size_t end = text.find(')');
    std::string& name = names_[std::string(text.substr(0, end + 1))];
    if (end + 2 < text.size()) name = text.substr(end + 2);
    return name;
  }

 private:
  std::map<std::string, std::string> names_;
};

/// The count of a line of costs, "LINE COUNT" or "+LINE COUNT": nothing but one event is counted.
std::int64_t cost(std::string_view line) {
  const std::size_t space = line.find(' ');
  return space == std::string_view::npos ? 0 : whole_number(line.substr(space + 1));
}

bool is_cost(std::string_view line) {
  return !line.empty() && std::string_view("0123456789+-*").find(line[0]) != std::string_view::npos;
}

/// Where the parameters of a function begin: at its first parenthesis that is neither a name without a name
/// nor an operator of calls nor inside template arguments.
std::size_t parameters(std::string_view text) {
  constexpr std::string_view unnamed = "(anonymous namespace)", call = "operator()";
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::string_view rest = text.substr(i);
    if (rest.starts_with(unnamed)) {
      i += unnamed.size() - 1;
    } else if (rest.starts_with(call)) {
      i += call.size() - 1;
    } else if (text[i] == '(' && depth == 0) {
      return i;
    } else if (text[i] == '<' || text[i] == '(' || text[i] == '{') {
      ++depth;
    } else if ((text[i] == '>' && (i == 0 || text[i - 1] != '-')) || text[i] == ')' || text[i] == '}') {
      --depth;
    }
  }
  return text.size();
}

}  // namespace

std::string_view qualified_name(std::string_view demangled) {
  const std::string_view name = demangled.substr(0, parameters(demangled));
  constexpr std::string_view unnamed = "(anonymous namespace)";
  int depth = 0;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (name.substr(i).starts_with(unnamed)) {
      i += unnamed.size() - 1;
    } else if (name[i] == '<' || name[i] == '(' || name[i] == '{') {
      ++depth;
    } else if (name[i] == '>' || name[i] == ')' || name[i] == '}') {
      --depth;
    } else if (name[i] == ' ' && depth == 0) {
      begin = i + 1;
    }
  }
  return name.substr(begin);
}

Profile read_profile(const fs::path& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error(file.string() + ": cannot be read");
  Profile profile;
  Names name;
  FunctionCount* function = nullptr;
  bool called = false;  // the next costs are those of a call
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("fn=")) {
      function = &profile.functions[name(std::string_view(line).substr(3))];
    } else if (line.starts_with("cfn=")) {
      name(std::string_view(line).substr(4));
      // The callee of the "calls=" that follows.
      std::string next;
      if (!std::getline(in, next) || !next.starts_with("calls="))
        throw std::runtime_error(file.string() + ": expected calls= after cfn=");
      profile.functions[name(std::string_view(line).substr(4))].calls += whole_number(next.substr(6));
      called = true;
    } else if (is_cost(line)) {
      if (!called && function != nullptr) {
        function->instructions += cost(line);
        profile.instructions += cost(line);
      }
      called = false;
    }
  }
  if (profile.functions.empty()) throw std::runtime_error(file.string() + ": holds no counts");
  return profile;
}

Profile profile(const std::vector<std::string>& command, const fs::path& folder) {
  const fs::path counts = folder / "callgrind.out", said = folder / "said.txt";
  std::string line =
      quoted(VALGRIND) +
      " --tool=callgrind --dump-instr=no --compress-pos=no --callgrind-out-file=" + quoted(counts.string()) +
      " --log-file=" + quoted((folder / "valgrind.txt").string());
  for (const std::string& argument : command) line += ' ' + quoted(argument);
  line += " >" + quoted(said.string()) + " 2>&1";
  if (std::system(line.c_str()) != 0) {
    std::ifstream in(said);
    std::string words;
    std::getline(in, words);
    throw std::runtime_error("counting failed: " + words);
  }
  return read_profile(counts);
}

}  // namespace verify::absent
