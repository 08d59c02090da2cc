// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/materials/material_formats.h"

#include <algorithm>

#include "core/io/byte_source.h"
#include "core/support/text.h"

namespace gonio::materials {

const MaterialFormat* formatBySuffix(const std::filesystem::path& path) {
  const std::string suffix = lowerCase(path.extension().string());
  for (const MaterialFormat* format : materialFormats())
    if (!format->isSuffixAmbiguous && std::ranges::find(format->suffixes, suffix) != format->suffixes.end())
      return format;
  return nullptr;
}

const MaterialFormat* formatOfFile(const std::filesystem::path& path) {
  try {
    return &sniffFormat(io::FileSource(path));
  } catch (const Error&) {
    return formatBySuffix(path);
  }
}

bool isMaterialFile(const std::filesystem::path& path) { return formatBySuffix(path) || formatOfFile(path); }

namespace {

/// Formats that people have and Gonio does not read, by suffix or by the start of their text.
struct UnreadFormat {
  std::string_view suffix, start, name;
};
constexpr UnreadFormat unreadFormats[] = {
    {".pbsdf", {}, "a polarimetric BSDF (.pbsdf)"},
    {".jdv", {}, "a JDV file (.jdv)"},
    {".rtd", {}, "an RTD file (.rtd)"},
    {{}, "type bsdf_data", "a FRED BSDF"},
    {{}, "OPTIS - BSDF180", "an Ansys Speos .bsdf180 file, whose binary layout is not published"},
    {{}, "OPTIS - ", "an Ansys Speos file other than .anisotropicbsdf and .brdf"}};

/// By content; empty for other files.
std::string unreadFormat(const io::ByteSource& source) {
  std::string head(std::size_t(std::min<std::uint64_t>(source.size(), 16)), '\0');
  source.readAt(0, std::as_writable_bytes(std::span(head)));
  for (const UnreadFormat& format : unreadFormats)
    if (!format.start.empty() && std::string_view(head).starts_with(format.start)) return std::string(format.name);
  return {};
}

}  // namespace

std::string unreadFormat(const std::filesystem::path& path) {
  const std::string suffix = lowerCase(path.extension().string());
  for (const UnreadFormat& format : unreadFormats)
    if (!format.suffix.empty() && suffix == format.suffix) return std::string(format.name);
  return {};
}

const MaterialFormat& sniffFormat(const io::ByteSource& source) {
  if (source.size() == 0) throw Error("the file is empty, expected a material");
  std::string refusals, verdict;
  for (const MaterialFormat* format : materialFormats()) {
    try {
      format->sniff(source);
      return *format;
    } catch (const io::FormatMismatch& mismatch) {
      const std::string refusal = "\n  " + std::string(format->name) + ": " + mismatch.what();
      if (!refusals.ends_with(refusal)) refusals += refusal;
      if (!mismatch.verdict().empty() && verdict.empty())
        verdict = mismatch.verdict() + " (" + std::string(format->name) + ")";
    }
  }
  if (const std::string unread = unreadFormat(source); verdict.empty() && !unread.empty())
    verdict = "found " + unread + ", which Gonio does not read";
  // What the other formats expect helps only if nothing is known about the file.
  throw Error(verdict.empty() ? "this file could not be read: it matches no format that Gonio supports" + refusals
                              : verdict);
}

namespace {

/// ".binary, .bsdf or .pdv".
std::string listOf(const std::vector<std::string_view>& suffixes, std::string_view conjunction) {
  std::string text;
  for (std::size_t i = 0; i < suffixes.size(); ++i) {
    if (i > 0) text.append(i + 1 < suffixes.size() ? ", " : " " + std::string(conjunction) + " ");
    text.append(suffixes[i]);
  }
  return text;
}

void addOnce(std::vector<std::string_view>& suffixes, std::string_view suffix) {
  if (std::ranges::find(suffixes, suffix) == suffixes.end()) suffixes.push_back(suffix);
}

}  // namespace

std::string suffixText(bool (*isWanted)(const MaterialFormat& format), std::string_view conjunction) {
  std::vector<std::string_view> suffixes;
  for (const MaterialFormat* format : materialFormats())
    if (isWanted(*format))
      for (const std::string_view suffix : format->suffixes) addOnce(suffixes, suffix);
  return listOf(suffixes, conjunction);
}

std::string writableSuffixText(std::string_view other) {
  std::vector<std::string_view> suffixes;
  for (const MaterialFormat* format : materialFormats())
    if (format->encode) addOnce(suffixes, format->suffix());
  if (!other.empty()) suffixes.push_back(other);
  return listOf(suffixes, "or");
}

}  // namespace gonio::materials
