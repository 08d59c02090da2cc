// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/program_cache.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "offscreen_context.h"
#include "tests/support/test_program.h"
#include "widgets/preview/gl/shader_library.h"

namespace program_cache_test {
using namespace gonio;

class ProgramCacheTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    if (!context_.isValid()) QSKIP("no OpenGL 4.1 core context on this machine");
    cache_.setCompileListener([this] { ++compilations_; });
  }
  void cleanupTestCase() { cache_.setFlatVectors({}); }

  /// However many combinations are shown one after the other, the memory is bounded; a program that is used again and
  /// again is compiled once.
  void keepsTheProgramsUsedLast() {
    constexpr int most = int(widgets::ProgramCache::maxPrograms);
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

  /// What a developer reads is what the driver got: complete, each file once and named.
  void writesShadersForReading() {
    const QTemporaryDir folder;
    qputenv("GONIO_SHADER_OUTPUT", folder.path().toUtf8());
    use(1000);
    use(1001);
    qunsetenv("GONIO_SHADER_OUTPUT");
    QFile second(folder.filePath("display-2.frag"));
    QVERIFY(second.open(QIODevice::ReadOnly));
    const QByteArray text = second.readAll();
    QCOMPARE(text, widgets::assembleShader("preview/display.frag", {"VARIANT 1001"}));
    QCOMPARE(text.count("// preview/display.frag\n"), 1);
    QVERIFY(!text.contains("#include"));
    QVERIFY(text.contains("void main()"));
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
