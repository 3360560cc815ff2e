// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include <zstd.h>

namespace mdana::test {

/// The text as one zstd frame with a checksum (RFC 8878).
inline std::string zstd_packed(std::string_view text, int level = 3) {
  ZSTD_CCtx* context = ZSTD_createCCtx();
  ZSTD_CCtx_setParameter(context, ZSTD_c_compressionLevel, level);
  ZSTD_CCtx_setParameter(context, ZSTD_c_checksumFlag, 1);
  std::string packed(ZSTD_compressBound(text.size()), '\0');
  const std::size_t size =
      ZSTD_compress2(context, packed.data(), packed.size(), text.data(), text.size());
  ZSTD_freeCCtx(context);
  if (ZSTD_isError(size)) throw std::runtime_error(ZSTD_getErrorName(size));
  packed.resize(size);
  return packed;
}

/// A skippable frame.
inline std::string zstd_skippable(std::string_view content) {
  std::string frame("\x50\x2a\x4d\x18", 4);
  for (int k = 0; k < 4; ++k) frame += static_cast<char>(content.size() >> (8 * k));
  return frame + std::string(content);
}

}  // namespace mdana::test
