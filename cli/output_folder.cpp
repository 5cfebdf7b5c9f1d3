#include "output_folder.hpp"

#include <unistd.h>

#include "bad_input.hpp"
#include "numbers.hpp"
#include "signals.hpp"

namespace cli {

namespace fs = std::filesystem;

void require_writable(const fs::path& folder) {
  std::error_code error;
  fs::path there = fs::absolute(folder, error);
  while (!fs::exists(fs::symlink_status(there, error)) && there != there.parent_path())
    there = there.parent_path();
  if (folder.empty() || !fs::is_directory(there, error) || access(there.c_str(), W_OK | X_OK) != 0) {
    throw BadInput("--out: " + in_quotes(folder.string()) +
                   " cannot be written; expected the name of a folder, there or not, to write into");
  }
}

void write_together(const std::vector<contensou::FileText>& files) {
  const SignalsHeld held;
  contensou::write_files(files);
}

}  // namespace cli
