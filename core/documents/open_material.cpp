// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/documents/open_material.h"

#include <algorithm>
#include <span>
#include <string_view>

#include "core/documents/blend_source.h"
#include "core/io/byte_source.h"
#include "core/io/text_lines.h"
#include "core/support/error.h"

namespace gonio::documents {

namespace {

/// Up to `count` bytes of a file as text; empty if it cannot be read, which reading the material reports.
std::string beginningOf(const std::string& path, std::uint64_t count) try {
  const io::FileSource source(path);
  std::string text(std::size_t(std::min(source.size(), count)), '\0');
  source.readAt(0, std::as_writable_bytes(std::span(text)));
  return text;
} catch (const Error&) {
  return {};
}

/// Whether a JSON text has the member that documents have: "format": "gonio document".
bool hasDocumentFormat(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n", member = "\"format\"";
  for (std::size_t at = text.find(member); at != text.npos; at = text.find(member, at + 1)) {
    const std::size_t colon = std::min(text.find_first_not_of(blanks, at + member.size()), text.size() - 1);
    const std::size_t value = text.find_first_not_of(blanks, colon + 1);
    if (text[colon] == ':' && value != text.npos && text.substr(value).starts_with("\"gonio document\"")) return true;
  }
  return false;
}

}  // namespace

bool isDocument(const std::string& path) {
  constexpr std::uint64_t start = 4096, maxText = std::uint64_t(1) << 26;
  const std::string beginning = beginningOf(path, start);
  const std::string_view text = io::withoutByteOrderMark(beginning);
  const std::size_t first = text.find_first_not_of(" \t\r\n\f\v");
  if (first == text.npos || text[first] != '{') return false;
  // Other programs write JSON too (glTF, OpenMATERIAL); what is named a document is read as one, with its faults.
  return isDocumentName(path) || hasDocumentFormat(beginningOf(path, maxText));
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
