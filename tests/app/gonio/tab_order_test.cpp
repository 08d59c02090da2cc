// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include <QAbstractButton>
#include <QDockWidget>
#include <QKeySequence>
#include <QLabel>
#include <QMap>
#include <QSettings>
#include <QStandardPaths>
#include <QTabBar>
#include <QTest>

#include "app/gonio/acquisition/acquisition_panel.h"
#include "app/gonio/acquisition/photograph_panel.h"
#include "app/gonio/comparison/comparison_panel.h"
#include "app/gonio/comparison/reference_dialog.h"
#include "app/gonio/export/batch_dialog.h"
#include "app/gonio/export/export_dialog.h"
#include "app/gonio/export/image_dialog.h"
#include "app/gonio/factors/factor_curves_panel.h"
#include "app/gonio/figures/figure_dialog.h"
#include "app/gonio/inspector/inspector.h"
#include "app/gonio/interpolation/interpolation_panel.h"
#include "app/gonio/plots/plots_panel.h"
#include "app/gonio/scene/scene_panel.h"
#include "app/gonio/scene/view_strip.h"
#include "app/gonio/study/study_window.h"
#include "app/gonio/window/dock_layout.h"
#include "app/gonio/window/main_window.h"
#include "app/gonio/window/preferences.h"
#include "core/models/model.h"
#include "tests/app/gonio/glossy_material.h"
#include "tests/support/test_program.h"
#include "tests/widgets/offscreen_context.h"
#include "widgets/library/library_view.h"
#include "widgets/preview/comparison_bar.h"
#include "widgets/preview/preview_widget.h"

namespace tab_order_test {
using namespace gonio;
using namespace gonio::app;

QRect placeOf(const QWidget& widget) { return {widget.mapToGlobal(QPoint()), widget.size()}; }

/// What Tab visits in a part of a window from its upper left on, until it leaves the part or comes back.
std::vector<QWidget*> stops(const QWidget& part) {
  std::vector<QWidget*> result;
  part.window()->activateWindow();
  if (!QTest::qWaitForWindowActive(part.window())) return result;
  for (QWidget* widget : part.findChildren<QWidget*>())
    if (widget->isVisible() && widget->isEnabled() && widget->focusPolicy() & Qt::TabFocus && !widget->focusProxy())
      result.push_back(widget);
  if (result.empty()) return result;
  QWidget* focus = *std::ranges::min_element(result, {}, [](const QWidget* one) {
    const QRect place = placeOf(*one);
    return std::pair(place.top(), place.left());
  });
  focus->setFocus();
  result.clear();
  while (focus && part.isAncestorOf(focus) && !std::ranges::count(result, focus)) {
    result.push_back(focus);
    QTest::keyClick(focus, Qt::Key_Tab);
    focus = QApplication::focusWidget();
  }
  return result;
}

QString named(const QWidget& widget) {
  const QString text = widget.property("text").toString();
  const QRect place = placeOf(widget);
  return QStringLiteral("%1 \"%2\" (%3, %4)")
      .arg(widget.metaObject()->className(), widget.accessibleName().isEmpty() ? text : widget.accessibleName())
      .arg(place.x())
      .arg(place.y());
}

/// The eye goes along a row, then to the row below; or on to the column at the right.
bool follows(const QRect& next, const QRect& before) {
  const bool below = next.top() >= before.center().y(), right = next.left() >= before.center().x();
  return below || right || before.contains(next);  // a row of a list with parts of its own
}

/// Steps of Tab that lead back, or that there are none at all.
QStringList stepsBack(const QWidget& part) {
  QStringList found;
  const std::vector<QWidget*> order = stops(part);
  if (order.empty()) found << QStringLiteral("nothing to visit");
  for (std::size_t i = 1; i < order.size(); ++i)
    if (!follows(placeOf(*order[i]), placeOf(*order[i - 1]))) found << named(*order[i - 1]) + " -> " + named(*order[i]);
  return found;
}

#define VERIFY_FOLLOWS_THE_EYE(part)                                                      \
  do {                                                                                    \
    const QStringList found = stepsBack(part);                                            \
    QVERIFY2(found.isEmpty(), qPrintable(QStringLiteral(#part "\n") + found.join('\n'))); \
  } while (false)

/// Keys (Alt and a letter) that lead nowhere or that two parts share, of what is visible.
QStringList keyProblems(const QWidget& part, bool isDialog) {
  QStringList found;
  QMap<QString, QString> owners;
  for (const QWidget* widget : part.findChildren<QWidget*>()) {
    if (!widget->isVisible()) continue;
    const auto* label = qobject_cast<const QLabel*>(widget);
    if (!(label && label->buddy()) && !qobject_cast<const QAbstractButton*>(widget)) continue;
    const QString text = widget->property("text").toString(), key = QKeySequence::mnemonic(text).toString();
    if (key.isEmpty()) continue;
    if (label && label->buddy()->focusPolicy() == Qt::NoFocus) found << text + ": no field";
    if (isDialog && owners.contains(key)) found << owners[key] + " and " + text;
    owners[key] = text;
  }
  return found;
}

class TabOrderTest : public QObject {
  Q_OBJECT

  MainWindow* m_window = nullptr;

  static void show(QWidget& dialog) {
    dialog.show();
    QVERIFY(QTest::qWaitForWindowExposed(&dialog));
  }

 private Q_SLOTS:
  void initTestCase() {
    QStandardPaths::setTestModeEnabled(true);
    const test::OffscreenContext context;
    if (!context.isValid()) QSKIP("needs an OpenGL 4.1 context");
    m_window = new MainWindow;
    m_window->resize(1600, 1000);
    m_window->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_window));
    EditorParts& parts = m_window->parts();
    parts.document.setMaterial(test_support::glossyMaterial(0.3, HalfDifferenceGrid{8, 8, 8}));
    fitting::FitResult fit;
    fit.model = &defaultModel();
    fit.parameters = models::defaultParameters(fit.model->spec());
    parts.document.adoptFit(fit);
    parts.comparison.setComparison({.mode = widgets::CompareMode::split});
    parts.libraryView.setChipsShown(true);
    QTest::qWait(50);
  }
  void cleanupTestCase() { delete m_window; }

  void panels() {
    EditorParts& parts = m_window->parts();
    const std::pair<const char*, QWidget*> docks[] = {{"library", &parts.libraryView},
                                                      {"inspector", &parts.inspector},
                                                      {"plots", &parts.plots},
                                                      {"comparison", &parts.comparisonPanel},
                                                      {"factors", &parts.factors},
                                                      {"interpolation", &parts.interpolation},
                                                      {"scene", &parts.scene},
                                                      {"acquisition", &parts.acquisition},
                                                      {"photographs", &parts.photographs}};
    QStringList back;
    for (const auto& [name, panel] : docks) {
      m_window->docks().show(name);
      QTest::qWait(20);
      for (const QString& problem : stepsBack(*panel) + keyProblems(*panel, false))
        back << QString(name) + ": " + problem;
    }
    QVERIFY2(back.isEmpty(), qPrintable('\n' + back.join('\n')));
    VERIFY_FOLLOWS_THE_EYE(parts.comparisonBar);
    VERIFY_FOLLOWS_THE_EYE(parts.viewStrip);
  }

  /// From the left to the right, then to what is below.
  void theWindow() {
    EditorParts& parts = m_window->parts();
    m_window->docks().show("plots");
    const QWidget* order[] = {&parts.libraryView, &parts.comparisonBar, &parts.preview,
                              &parts.viewStrip,   &parts.inspector,     &parts.plots};
    const auto visited = [&] {
      std::vector<std::size_t> found;
      for (const QWidget* stop : stops(*m_window))
        for (std::size_t i = 0; i < std::size(order); ++i)
          if ((order[i] == stop || order[i]->isAncestorOf(stop)) && (found.empty() || found.back() != i))
            found.push_back(i);
      std::rotate(found.begin(), std::ranges::find(found, std::size_t(0)), found.end());
      return found;
    };
    // The panel becomes visible when events are handled.
    QTRY_COMPARE(visited(), std::vector<std::size_t>({0, 1, 2, 3, 4, 5}));
  }

  void dialogs() {
    EditorParts& parts = m_window->parts();
    PreferencesDialog preferences({}, "Renderer", m_window);
    show(preferences);
    VERIFY_FOLLOWS_THE_EYE(preferences);
    BatchDialog batch(parts.exporter, parts.settings, {"library:sgd/brass", "library:sgd/chrome"}, m_window);
    show(batch);
    VERIFY_FOLLOWS_THE_EYE(batch);
    ExportDialog exporting(parts.exporter, parts.settings, parts.preview.content().scene(), m_window);
    show(exporting);
    VERIFY_FOLLOWS_THE_EYE(exporting);
    ReferenceDialog reference(parts.library.model(), m_window);
    show(reference);
    VERIFY_FOLLOWS_THE_EYE(reference);
    for (const auto page : {StudyWindow::ResultsPage, StudyWindow::ChartPage, StudyWindow::SheetPage}) {
      parts.study.present(page);
      show(parts.study);
      VERIFY_FOLLOWS_THE_EYE(parts.study);
    }
    parts.study.hide();
    FigureDialog figure(parts.figureParts(), m_window);
    show(figure);
    VERIFY_FOLLOWS_THE_EYE(figure);
    ImageDialog picture({parts.document, parts.exports, parts.tasks, parts.comparison, parts.preview, parts.settings},
                        "glossy", m_window);
    show(picture);
    VERIFY_FOLLOWS_THE_EYE(picture);
    QStringList problems;
    for (const QWidget* dialog :
         std::initializer_list<const QWidget*>{&preferences, &batch, &exporting, &reference, &figure, &picture})
      for (const QString& problem : keyProblems(*dialog, true)) problems << dialog->windowTitle() + ": " + problem;
    QVERIFY2(problems.isEmpty(), qPrintable('\n' + problems.join('\n')));
  }
};

GONIO_TEST(TabOrderTest)
}  // namespace tab_order_test

#include "tab_order_test.moc"
