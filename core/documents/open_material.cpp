// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/documents/open_material.h"

#include <algorithm>
#include <string_view>

#include "core/documents/blend_source.h"
#include "core/io/byte_source.h"
#include "core/io/text_lines.h"
#include "core/support/error.h"

namespace gonio::documents {

bool isDocument(const std::string& path) {
  constexpr std::size_t maxStart = 4096;
  std::vector<std::byte> start;
  try {
    const io::FileSource source(path);
    start.resize(std::min<std::uint64_t>(source.size(), maxStart));
    source.readAt(0, start);
  } catch (const Error&) {  // reading the material reports the error
    return false;
  }
  const std::string_view text = io::withoutByteOrderMark({reinterpret_cast<const char*>(start.data()), start.size()});
  const std::size_t first = text.find_first_not_of(" \t\r\n\f\v");
  return first != text.npos && text[first] == '{';
}

materials::EditedMaterial editedMaterial(const std::filesystem::path& path, const TaskControl& control) {
  const EditDocument document = readDocument(path);
  materials::EditedMaterial edited{
      .shown = {}, .base = readSource(document, path, control), .edits = document.edits, .incident = document.incident};
  if (edited.base.source.sha256 != document.sourceSha256)
    throw Error(path.string() + ": its source " +
                (document.blend ? "(" + edited.base.source.description + ")" : edited.base.source.path.string()) +
                " has changed: found SHA-256 " + edited.base.source.sha256 + ", expected " + document.sourceSha256);
  edited.shown = materials::withEdits(edited.base, document.edits, control);
  if (editing::isIdentity(document.edits) && !document.blend) return edited;
  edited.shown.name = path.stem().string();
  edited.shown.source.path = std::filesystem::absolute(path).lexically_normal();
  edited.shown.source.format = "gonio document";
  return edited;
}

materials::EditedMaterial openWithEdits(const std::string& path, const TaskControl& control) {
  return isDocument(path) ? editedMaterial(path, control) : materials::unedited(materials::readMaterial(path, control));
}

materials::Material openMaterial(const std::string& path, const TaskControl& control) {
  return openWithEdits(path, control).shown;
}

std::vector<std::filesystem::path> filesOf(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return {};
  std::vector<std::filesystem::path> files{path};
  if (!isDocument(path)) return files;
  try {
    std::ranges::copy(sourceFiles(resolved(readDocument(path), path)), std::back_inserter(files));
  } catch (const Error&) {  // opening the document reports the error
  }
  return files;
}

}  // namespace gonio::documents
