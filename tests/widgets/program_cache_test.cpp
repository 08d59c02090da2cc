// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/program_cache.h"

#include <QTest>

#include "offscreen_context.h"
#include "tests/support/test_program.h"

namespace program_cache_test {
using namespace gonio;

class ProgramCacheTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    if (!context_.isValid()) QSKIP("no OpenGL 4.1 core context on this machine");
    cache_.setCompileListener([this] { ++compilations_; });
  }
  void cleanupTestCase() { cache_.clear(); }

  /// However many combinations are shown one after the other, the memory is bounded; a program that is used again and
  /// again is compiled once.
  void keepsTheProgramsUsedLast() {
    constexpr int most = int(widgets::ProgramCache::mostPrograms);
    const GLuint often = use(0);
    for (int i = 1; i < most + 10; ++i) {
      use(i);
      QCOMPARE(use(0), often);
    }
    QCOMPARE(compilations_, most + 10);
    // The last ones are kept, the first ones are not.
    for (int i = 11; i < most + 10; ++i) use(i);
    QCOMPARE(compilations_, most + 10);
    use(1);
    QCOMPARE(compilations_, most + 11);
  }

 private:
  /// One of many variants of a program.
  GLuint use(int variant) {
    return cache_.program("preview/display.frag", {QStringLiteral("VARIANT %1").arg(variant)}, {}).programId();
  }

  const test::OffscreenContext context_;
  widgets::ProgramCache cache_;
  int compilations_ = 0;
};

GONIO_TEST(ProgramCacheTest)
}  // namespace program_cache_test

#include "program_cache_test.moc"
