// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <map>
#include <string>

/// One program, gonio_studies, holds the studies; its first argument names the one to run.
namespace gonio::study {

/// Returns the exit code. The first argument is the study's name. @throws std::exception, of which the text is printed.
using StudyFunction = int (*)(int argumentCount, char** arguments);

/// The studies by the names of their files, without "_study.cpp".
std::map<std::string, StudyFunction>& registeredStudies();

struct StudyRegistration {
  StudyRegistration(const char* file, StudyFunction function) {
    const std::string stem = std::filesystem::path(file).stem().string();
    registeredStudies().emplace(stem.substr(0, stem.rfind("_study")), function);
  }
};

}  // namespace gonio::study

/// Registers the function of a study, in the study's own namespace (several files are compiled as one).
#define GONIO_STUDY(function) static const gonio::study::StudyRegistration registration(__FILE__, function);
