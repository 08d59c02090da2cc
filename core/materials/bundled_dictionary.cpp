// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/materials/dictionary_file.h"

extern "C" {
// Of the file that the build takes in (bundled_files.S).
extern const std::byte gonioBundledDictionary[];
extern const std::byte gonioBundledDictionaryEnd[];
}

namespace gonio::materials {

std::shared_ptr<const NamedEnsemble> bundledEnsemble() {
  static const std::shared_ptr<const NamedEnsemble> dictionary = readDictionary(
      io::MemorySource({gonioBundledDictionary, std::size_t(gonioBundledDictionaryEnd - gonioBundledDictionary)}));
  return dictionary;
}

}  // namespace gonio::materials
