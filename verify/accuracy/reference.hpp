#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace accuracy {

/// 113 bits (34 digits) with a range far beyond a double's:
/// the stored tables are read and compared in this type.
using Quad = boost::multiprecision::cpp_bin_float_quad;

/// One row of a stored table: an exact double u, and the law there to 34 digits.
struct ReferenceRow {
  std::string range;  ///< empty in a table without ranges
  double u;
  Quad phi;
  Quad xi;
  Quad eta;
  Quad second;  ///< f″(u)
};

/// Reads reference_data/accuracy/*.tsv or reference_data/laws/*.tsv. The column f2 (f″ for u <= 1, u³f″ for u
/// > 1) is turned into f″. Throws std::runtime_error naming the file where it is missing or malformed.
std::vector<ReferenceRow> read_reference(const std::filesystem::path& path);

/// The interval of u of each named range, "seam_in" -> "[0.9, 1)", from the comment `# range: NAME INTERVAL
/// ...`.
std::map<std::string, std::string> range_intervals(const std::filesystem::path& path);

/// The value of `# n = <number> ...` in a table's comments.
double reference_exponent(const std::filesystem::path& path);

}  // namespace accuracy
