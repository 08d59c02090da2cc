// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include <QLabel>
#include <QSignalSpy>
#include <QTest>

#include "core/models/model.h"
#include "core/models/registry.h"
#include "tests/support/test_program.h"
#include "widgets/preview/preview_widget.h"

namespace no_opengl_test {
using namespace gonio;
using widgets::PreviewWidget;

/// The preview on a machine without OpenGL.
class NoOpenglTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    if (QGuiApplication::platformName() != "offscreen") QSKIP("needs the platform offscreen");
    qunsetenv("DISPLAY");  // from which it takes OpenGL
  }

  /// Reported once; the preview shows it as long as it is true.
  void theReasonIsReportedOnce() {
    PreviewWidget preview;
    QSignalSpy failed(&preview, &PreviewWidget::failed);
    preview.resize(400, 300);
    preview.show();
    QTRY_COMPARE(failed.count(), 1);
    const QString message = failed[0][0].toString();
    QVERIFY2(message.contains("OpenGL"), qPrintable(message));
    const auto isShown = [&] {
      for (const QLabel* label : preview.findChildren<QLabel*>())
        if (label->isVisible() && label->text() == message) return true;
      return false;
    };
    QVERIFY(isShown());
    const models::Model& model = models::findModel("lambert");
    const auto material = bakeTable(*model.instantiate(models::defaultParameters(model.spec())));
    for (int i = 0; i < 3; ++i) {
      preview.content().setSubject(widgets::measuredSubject(material));
      preview.setExposure(i);
      QTest::qWait(50);
      preview.content().setSubject({});
      QTest::qWait(50);
    }
    QCOMPARE(failed.count(), 1);
    QVERIFY(isShown());
    QVERIFY(preview.grabPicture().isNull() && !preview.converged());
  }
};

GONIO_TEST(NoOpenglTest)
}  // namespace no_opengl_test

#include "no_opengl_test.moc"
