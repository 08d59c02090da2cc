// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include <QAbstractItemModel>
#include <QStandardPaths>
#include <QTest>

#include "app/gonio/document/document_controller.h"
#include "app/gonio/document/edit_steps.h"
#include "app/gonio/inspector/inspector.h"
#include "app/gonio/window/editor_parts.h"
#include "app/gonio/window/main_window.h"
#include "core/models/model.h"
#include "tests/app/gonio/document_edits.h"
#include "tests/app/gonio/patience.h"
#include "tests/support/test_program.h"

namespace slider_step_test {
using namespace gonio;
using namespace gonio::app;
using namespace gonio::app::test_support;

/// What is made anew in a window: tooltips, rows of models, widgets.
class Rebuilds : public QObject {
 public:
  explicit Rebuilds(QWidget& window) {
    for (QWidget* widget : window.findChildren<QWidget*>()) widget->installEventFilter(this);
    for (const auto* model : window.findChildren<QAbstractItemModel*>()) {
      if (model->inherits("QUndoModel")) continue;  // Qt's list of the history has the step that grows
      const auto count = [this, model] { m_found << describe(*model) + " changed"; };
      connect(model, &QAbstractItemModel::modelReset, this, count);
      connect(model, &QAbstractItemModel::rowsInserted, this, count);
      connect(model, &QAbstractItemModel::rowsRemoved, this, count);
      connect(model, &QAbstractItemModel::dataChanged, this, count);
    }
  }
  const QStringList& found() const { return m_found; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::ToolTipChange) m_found << describe(*watched) + ": tooltip";
    if (event->type() == QEvent::ChildAdded) m_found << describe(*watched) + ": child";
    return false;
  }

 private:
  static QString describe(const QObject& object) {
    const auto* widget = qobject_cast<const QWidget*>(&object);
    return QString("%1 %2 in %3")
        .arg(object.metaObject()->className(), widget ? widget->accessibleName() : QString(),
             object.parent() ? object.parent()->metaObject()->className() : "nothing");
  }

  QStringList m_found;
};

class SliderStepTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() { QStandardPaths::setTestModeEnabled(true); }
  /// What a step does not change stays: no tooltip, no row of a model and no widget is made anew. The first step marks
  /// the edit as modified and the measured numbers as outdated.
  void aStepRebuildsNothing() {
    const auto window = std::make_unique<MainWindow>();
    window->show();
    EditorParts& parts = window->parts();
    parts.document.setMaterial(greyMaterial());
    adoptDefaultFit(parts.document);
    QVERIFY(QTest::qWaitFor([&] { return parts.tasks.isIdle() && parts.inspector.isSettled(); }, patienceMilliseconds));
    parts.document.beginInteraction();
    const auto step = [&](double value) { setParameter(parts.document, 0, Rgb(value)); };
    step(0.3);
    Rebuilds rebuilds(*window);
    for (int i = 1; i <= 10; ++i) step(0.3 + 0.01 * i);
    parts.document.endInteraction();
    QVERIFY2(rebuilds.found().isEmpty(), qPrintable(rebuilds.found().join('\n')));
    QVERIFY(modelEdit(parts.document)->edited.values[0] == Rgb(0.3 + 0.01 * 10));
  }
};

GONIO_TEST(SliderStepTest)
}  // namespace slider_step_test

#include "slider_step_test.moc"
