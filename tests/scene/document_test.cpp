#include "contensou/scene/document.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "refusal.hpp"

using namespace contensou;
using contensou::test::refusal_of;

namespace {

const SceneValue& at(const SceneDocument& document, std::string_view key) {
  const auto entry = document.values.find(key);
  REQUIRE(entry != document.values.end());
  return entry->second;
}

double number(const SceneDocument& document, std::string_view key) {
  return std::get<double>(at(document, key).value);
}

}  // namespace

TEST_CASE("Scene document: values under their dotted names, with their lines", "[scene]") {
  const SceneDocument document = parse_document(
      "top = 1\n[a]\nx = 0.1\ny = -3 # three\n[a.b]\nword = \"slow\"\nyes = true\nlist = [1, 2.5]\n"
      "inline = {x = 1e300, y.z = inf}\n[empty]\n",
      "file.toml");
  CHECK(document.values.size() == 9);
  CHECK(number(document, "top") == 1);
  CHECK(number(document, "a.x") == 0.1);
  CHECK(number(document, "a.y") == -3);
  CHECK(at(document, "a.y").line == 4);
  CHECK(std::get<std::string>(at(document, "a.b.word").value) == "slow");
  CHECK(at(document, "a.b.word").text == "\"slow\"");
  CHECK(std::get<bool>(at(document, "a.b.yes").value));
  CHECK(std::get<std::vector<double>>(at(document, "a.b.list").value) == std::vector<double>{1, 2.5});
  CHECK(at(document, "a.b.list").text == "[1, 2.5]");
  CHECK(number(document, "a.b.inline.x") == 1e300);
  CHECK(std::isinf(number(document, "a.b.inline.y.z")));
  CHECK(at(document, "a.b.inline.y.z").line == 9);
  CHECK(std::holds_alternative<std::monostate>(at(document, "empty").value));
  CHECK(where(document, "a.y", at(document, "a.y")) == "file.toml:4: a.y");
}

TEST_CASE("Scene document: a quoted key is no dotted name", "[scene]") {
  const SceneDocument document = parse_document("\"a.b\" = 1\na.c = 2\n\"\\n\" = 3\n", "f");
  CHECK(document.values.contains("\"a.b\""));
  CHECK(!document.values.contains("a.b"));
  CHECK(document.values.contains("a.c"));
  CHECK(document.values.contains("\"\\x0a\""));
}

TEST_CASE("Scene document: tables and the lines that name them first", "[scene]") {
  SceneDocument document = parse_document("[a]\nx = 1\n[a.b]\n[c.d]\ny = 2\n[a.e]\nf = {g = 1}\n", "f");
  using Tables = std::map<std::string, int, std::less<>>;
  CHECK(document.tables == Tables{{"a", 1}, {"a.b", 3}, {"a.e", 6}, {"a.e.f", 7}, {"c", 4}, {"c.d", 4}});
  unset_value(document, "a.e.f.g");
  CHECK(document.tables.contains("a.e.f"));  // a table that has lost its last key is still there
  set_value(document, "c={h={i=1}}");
  CHECK(document.tables.at("c") == 0);
  CHECK(document.tables.at("c.h") == 0);
  CHECK(!document.tables.contains("c.d"));
}

TEST_CASE("Scene document: arrays of numbers and of strings", "[scene]") {
  const SceneDocument document = parse_document(
      "n = [1, -2.5, inf]\ns = [\"a\", \"b\"]\nempty = []\nmixed = [1, \"a\"]\ndeep = [[1]]\n"
      "truths = [true]\nlong = [1, 2, 3, 4, 5, 6, 7, 8]\n",
      "f");
  const auto& numbers = std::get<std::vector<double>>(at(document, "n").value);
  CHECK((numbers.size() == 3 && numbers[1] == -2.5 && std::isinf(numbers[2])));
  CHECK(std::get<std::vector<std::string>>(at(document, "s").value) == std::vector<std::string>{"a", "b"});
  CHECK(at(document, "s").text == "[\"a\", \"b\"]");
  CHECK(std::get<std::vector<double>>(at(document, "empty").value).empty());
  for (const char* key : {"mixed", "deep", "truths"})
    CHECK(std::holds_alternative<std::monostate>(at(document, key).value));
  CHECK(std::get<std::vector<double>>(at(document, "long").value).size() == 8);
  CHECK(at(document, "long").text == "[1, 2, 3, 4, 5, 6, ...]");
}

TEST_CASE("Scene document: numbers are read to the last bit", "[scene]") {
  const SceneDocument document = parse_document(
      "a = 0.1\nb = 1.7976931348623157e308\nc = 5e-324\nd = 9007199254740993\ne = 1_000.5\nf = 0x10\n", "f");
  CHECK(number(document, "a") == 0.1);
  CHECK(number(document, "b") == std::numeric_limits<double>::max());
  CHECK(number(document, "c") == std::numeric_limits<double>::denorm_min());
  CHECK(number(document, "d") == 9007199254740992.0);  // half-way, to even
  CHECK(number(document, "e") == 1000.5);
  CHECK(number(document, "f") == 16);
}

TEST_CASE("Scene document: --set puts a value in the place of another", "[scene]") {
  SceneDocument document = parse_document("[a]\nx = 1\ny = 2\n[a.b]\nz = 3\n", "f");
  set_value(document, "a.x=0.5");
  CHECK(number(document, "a.x") == 0.5);
  CHECK(where(document, "a.x", at(document, "a.x")) == "--set a.x");
  CHECK(at(document, "a.y").line == 3);

  set_value(document, "a.x=rk4");
  CHECK(std::get<std::string>(at(document, "a.x").value) == "rk4");
  set_value(document, "a.x=power:2");
  CHECK(std::get<std::string>(at(document, "a.x").value) == "power:2");
  set_value(document, "a.x=\"in = quotes # here\"");
  CHECK(std::get<std::string>(at(document, "a.x").value) == "in = quotes # here");
  set_value(document, "a.x=true");
  CHECK(std::get<bool>(at(document, "a.x").value));
  set_value(document, "a.x=1 # one");  // a comment is not dropped in silence
  CHECK(std::get<std::string>(at(document, "a.x").value) == "1 # one");
  set_value(document, "a.x=1] #");
  CHECK(std::get<std::string>(at(document, "a.x").value) == "1] #");

  set_value(document, "a.x=[0, 0.5, 1]");
  CHECK(std::get<std::vector<double>>(at(document, "a.x").value) == std::vector<double>{0, 0.5, 1});
  CHECK(at(document, "a.x").text == "[0, 0.5, 1]");
  set_value(document, "a.x=['p', 'q']");
  CHECK(std::get<std::vector<std::string>>(at(document, "a.x").value).size() == 2);

  set_value(document, "new.key=7");
  CHECK(number(document, "new.key") == 7);
  set_value(document, "a={w = 4, v.u = 5}");
  CHECK(number(document, "a.w") == 4);
  CHECK(number(document, "a.v.u") == 5);
  CHECK(!document.values.contains("a.y"));
  CHECK(!document.values.contains("a.b.z"));
  set_value(document, "a=1");
  CHECK(!document.values.contains("a.w"));
  CHECK(number(document, "a") == 1);
}

TEST_CASE("Scene document: --unset removes a key or a table", "[scene]") {
  SceneDocument document = parse_document("ab = 0\n[a]\nx = 1\ny = 2\n[a.b]\nz = 3\n", "f");
  unset_value(document, "a.x");
  CHECK(!document.values.contains("a.x"));
  CHECK(refusal_of([&] { unset_value(document, "a.x"); }).find("\"a.x\" is not in the scene") !=
        std::string::npos);
  unset_value(document, "a");
  CHECK(document.values.size() == 1);
  CHECK(document.values.contains("ab"));
}

TEST_CASE("Scene document: what is not TOML is refused with its line", "[scene]") {
  for (const char* bad :
       {"a", "a =", "a = 1 1", "[a", "[.]", "[[=]]", "[,", "a = 1\na = 2", "a = \"", "a = 01", "a = '", "=",
        "a = [", "a = 2020-13-01", "a = 1e", "[[a]]\n[a]", "\u00e9 = 1", "a = \u00e9", "a = 1 \u00b5"}) {
    const std::string message = refusal_of([&] { parse_document("x = 1\n\n" + std::string(bad), "f.toml"); });
    INFO(bad << ": " << message);
    CHECK((message.starts_with("f.toml:3: ") || message.starts_with("f.toml:4: ")));
    CHECK(message.find('\n') == std::string::npos);
    CHECK(message.find("expected") != std::string::npos);
  }
}

TEST_CASE("Scene document: depth that would exhaust the stack is refused", "[scene]") {
  const auto repeated = [](std::string_view part, std::size_t size) {
    std::string text;
    while (text.size() + part.size() <= size) text += part;
    return text;
  };
  const std::size_t size = largest_scene - 10;
  for (const std::string_view part : {".a", " . \"#\"", ".'\"'", ".\"\\\"\""}) {
    std::string deep = repeated(part, size / 2);
    deep.insert(0, 1, 'a');
    CHECK(refusal_of([&] { parse_document(deep + " = 1", "f"); }).find("100 parts") != std::string::npos);
    CHECK(refusal_of([&] { parse_document('[' + deep + ']', "f"); }).find("100 parts") != std::string::npos);
    CHECK(refusal_of([&] { parse_document("# x\nb = {" + deep + " = 1}", "f"); }).starts_with("f:2: "));
  }
  for (const std::string_view part : {"[", "{a = ", "[{a = "}) {
    CHECK(refusal_of([&] { parse_document("a = " + repeated(part, size), "f"); }).starts_with("f:1: "));
  }
  // What only looks like it: strings, comments, lists of numbers, leaders of dots.
  const std::string dots = repeated(".", 10000);
  CHECK_NOTHROW(parse_document("a = \"" + dots + "\" # " + dots + "\nb = '''\n" + dots + "'''\n", "f"));
  CHECK_NOTHROW(parse_document("a = [" + repeated("0.5, ", 10000) + "]\n", "f"));
  CHECK_NOTHROW(parse_document(repeated("a.b.c = 1 # x\n", 14) + repeated("\n", 100), "f"));
}
