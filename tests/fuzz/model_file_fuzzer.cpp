#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "io/read_model.hpp"
#include "io/write_model.hpp"

/// Every text is either a model, which can be written and comes back unchanged, or an InputError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace bodyline;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  std::string written;
  try {
    written = io::write_model_text(io::read_model_text(text, "fuzzed"));
  } catch (const io::InputError&) {
    return 0;
  }
  if (io::write_model_text(io::read_model_text(written, "written")) != written) std::abort();
  return 0;
}
