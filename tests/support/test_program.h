// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QTest>
#include <filesystem>
#include <functional>
#include <map>
#include <string>

/// One program holds the tests of a module; its first argument names the one to run (CTest starts it once for each).
namespace gonio::test {

using TestFunction = std::function<int(int argumentCount, char** arguments)>;

/// The tests of this program by the names of their files, without "_test.cpp".
std::map<std::string, TestFunction>& registeredTests();

/// Whether the environment variable GONIO_LONG_TESTS asks for more draws and more random cases than `./check` has time
/// for (scripts/long_tests.sh).
bool longTests();

struct Registration {
  Registration(const char* file, TestFunction function) {
    const std::string stem = std::filesystem::path(file).stem().string();
    registeredTests().emplace(stem.substr(0, stem.rfind("_test")), std::move(function));
  }
};

}  // namespace gonio::test

/// In place of QTEST_MAIN(): registers the test class of a file.
#define GONIO_TEST(TestClass)                                                                            \
  static const gonio::test::Registration registrationOf##TestClass(__FILE__, [](int argc, char** argv) { \
    TestClass test;                                                                                      \
    return QTest::qExec(&test, argc, argv);                                                              \
  });
