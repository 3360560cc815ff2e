// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/byte_source.hpp"

#include <array>

#include "readers/gzip.hpp"
#include "readers/raw_file.hpp"

namespace mdana {
namespace {

class PlainFile final : public ByteSource {
 public:
  explicit PlainFile(std::unique_ptr<RawFile> file) : file_(std::move(file)) {}

  std::size_t read(std::span<char> into) override { return file_->read(into); }
  std::optional<std::string_view> mapped() override { return file_->mapped(); }
  void passed(std::string_view bytes) override { file_->passed(bytes); }
  void mark() override { marked_ = file_->position(); }
  void reset() override { file_->seek(marked_); }
  InputRecord record() override { return file_->record(); }

 private:
  std::unique_ptr<RawFile> file_;
  std::uint64_t marked_ = 0;
};

bool is_gzip(RawFile& file) {
  std::array<char, 2> magic{};
  const std::size_t got = file.read(magic);
  file.seek(0);
  return got == 2 && magic[0] == '\x1f' && magic[1] == '\x8b';
}

}  // namespace

std::unique_ptr<ByteSource> open_bytes(const std::filesystem::path& path) {
  auto file = std::make_unique<RawFile>(path);
  if (is_gzip(*file)) return open_gzip(std::move(file));
  return std::make_unique<PlainFile>(std::move(file));
}

}  // namespace mdana
