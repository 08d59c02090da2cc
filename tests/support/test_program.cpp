// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "tests/support/test_program.h"

#include <cstdio>
#ifdef GONIO_WIDGET_TESTS
#include <QApplication>
using Application = QApplication;
#else
#include <QCoreApplication>
using Application = QCoreApplication;
#endif

namespace gonio::test {

std::map<std::string, TestFunction>& registeredTests() {
  static std::map<std::string, TestFunction> tests;
  return tests;
}

bool longTests() { return qEnvironmentVariableIntValue("GONIO_LONG_TESTS") != 0; }

}  // namespace gonio::test

int main(int argumentCount, char** arguments) {
  const auto& tests = gonio::test::registeredTests();
  const auto test = argumentCount > 1 ? tests.find(arguments[1]) : tests.end();
  if (test == tests.end()) {
    std::fprintf(stderr, "usage: %s TEST [ARGUMENTS OF QT TEST]\nTests:\n", arguments[0]);
    for (const auto& [name, function] : tests) std::fprintf(stderr, "  %s\n", name.c_str());
    return 2;
  }
  // Qt Test reads the arguments after the test's name.
  arguments[1] = arguments[0];
  --argumentCount;
  ++arguments;
#if defined(GONIO_WIDGET_TESTS) && defined(Q_OS_LINUX)
  // Without a display Qt would end the program; on the offscreen platform, tests of OpenGL find no context and skip.
  if (!qEnvironmentVariableIsSet("DISPLAY") && !qEnvironmentVariableIsSet("WAYLAND_DISPLAY"))
    qputenv("QT_QPA_PLATFORM", "offscreen");
#endif
  // What programs keep between runs does not come from the user, nor goes to them.
  qputenv("XDG_CACHE_HOME", GONIO_TEST_OUTPUT_DIR "/cache");
  QCoreApplication::setAttribute(Qt::AA_Use96Dpi);
  const Application application(argumentCount, arguments);
  return test->second(argumentCount, arguments);
}
