// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/byte_source.hpp"

#include <array>

#include "readers/gzip.hpp"
#include "readers/raw_file.hpp"
#include "readers/zstd.hpp"

namespace mdana {
namespace {

class PlainFile final : public ByteSource {
 public:
  explicit PlainFile(std::unique_ptr<RawFile> file) : file_(std::move(file)) {}

  std::size_t read(std::span<char> into) override { return file_->read(into); }
  std::optional<std::string_view> mapped() override { return file_->mapped(); }
  void passed(std::string_view bytes) override { file_->passed(bytes); }
  double share() const override { return file_->share(); }
  void mark() override { marked_ = file_->position(); }
  void reset() override { file_->seek(marked_); }
  void assume_hash(const std::string& hash) override { file_->assume_hash(hash); }
  const std::filesystem::path& path() const override { return file_->path(); }
  InputRecord record() override { return file_->record(); }

 private:
  std::unique_ptr<RawFile> file_;
  std::uint64_t marked_ = 0;
};

}  // namespace

std::unique_ptr<ByteSource> open_bytes(const std::filesystem::path& path) {
  auto file = std::make_unique<RawFile>(path);
  std::array<char, 4> magic{};
  const std::string_view head(magic.data(), file->read(magic));
  file->seek(0);
  if (head.starts_with("\x1f\x8b")) return open_gzip(std::move(file));
  if (is_zstd(head)) return open_zstd(std::move(file));
  return std::make_unique<PlainFile>(std::move(file));
}

}  // namespace mdana
