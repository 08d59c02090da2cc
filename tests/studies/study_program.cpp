// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "tests/studies/study_program.h"

#include <cstdio>
#include <exception>

namespace gonio::study {

std::map<std::string, StudyFunction>& registeredStudies() {
  static std::map<std::string, StudyFunction> studies;
  return studies;
}

}  // namespace gonio::study

int main(int argumentCount, char** arguments) try {
  const auto& studies = gonio::study::registeredStudies();
  const auto found = argumentCount > 1 ? studies.find(arguments[1]) : studies.end();
  if (found == studies.end()) {
    std::fprintf(stderr, "usage: gonio_studies STUDY [ARGUMENT ...]\nStudies:\n");
    for (const auto& [name, function] : studies) std::fprintf(stderr, "  %s\n", name.c_str());
    return 2;
  }
  return found->second(argumentCount - 1, arguments + 1);
} catch (const std::exception& error) {
  std::fprintf(stderr, "gonio_studies: %s\n", error.what());
  return 1;
}
