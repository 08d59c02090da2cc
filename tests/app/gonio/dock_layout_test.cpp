// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/dock_layout.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QLabel>
#include <QMainWindow>
#include <QMouseEvent>
#include <QRegularExpression>
#include <QTabBar>
#include <QTest>
#include <memory>
#include <random>

#include "tests/support/test_program.h"

namespace dock_layout_test {
using namespace gonio::app;
using Workspace = DockLayout::Workspace;

/// A window with docks at the same sides as in the editor, around a plain centre.
struct Window {
  QMainWindow window;
  DockLayout docks{window};

  Window() {
    window.setCentralWidget(new QLabel("centre"));
    docks.add("Library", "library", new QLabel("library"), Qt::LeftDockWidgetArea);
    docks.add("Inspector", "inspector", new QLabel("inspector"), Qt::RightDockWidgetArea);
    docks.add("History", "history", new QLabel("history"), Qt::RightDockWidgetArea)->hide();
    for (const char* name : {"plots", "comparison", "factors", "scene", "acquisition", "photographs"})
      docks.add(name, name, new QLabel(name), Qt::BottomDockWidgetArea);
    docks.setDefault();
    window.resize(1100, 800);
    window.show();
  }
  QStringList shown() const {
    QStringList names;
    for (const QDockWidget* dock : docks.docks())
      if (!dock->isHidden()) names << dock->objectName();
    return names;
  }
};

class DockLayoutTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void workspaces() {
    Window w;
    w.docks.showWorkspace(Workspace::compare);
    QCOMPARE(w.shown(), QStringList({"inspector", "comparison"}));
    w.docks.showWorkspace(Workspace::analyse);
    QCOMPARE(w.shown(), QStringList({"library", "inspector", "plots"}));
    w.docks.showWorkspace(Workspace::acquire);
    QCOMPARE(w.shown(), QStringList({"acquisition", "photographs"}));
    w.docks.showWorkspace(Workspace::edit);
    QCOMPARE(w.shown(), QStringList({"library", "inspector"}));
  }

  /// The focus of a panel that is hidden is the centre's; that of a panel that stays is not moved.
  void hiddenPanelsGiveTheFocusToTheCentre() {
    Window w;
    const auto part = [&w](const char* name) { return w.window.findChild<QDockWidget*>(name)->widget(); };
    for (QWidget* widget : {w.window.centralWidget(), part("inspector"), part("plots")})
      widget->setFocusPolicy(Qt::StrongFocus);
    part("inspector")->setFocus();
    w.docks.showWorkspace(Workspace::analyse);
    QCOMPARE(w.window.focusWidget(), part("inspector"));
    w.docks.showWorkspace(Workspace::acquire);
    QCOMPARE(w.window.focusWidget(), w.window.centralWidget());
  }

  /// The tabs of docks that lie behind one another have the icons of their menu entries.
  void tabsHaveIcons() {
    Window w;
    QPixmap square(16, 16);
    square.fill(Qt::red);
    for (const char* name : {"plots", "scene"}) w.docks.dock(name)->toggleViewAction()->setIcon(square);
    w.docks.show("plots");
    w.docks.show("scene");
    const auto iconsOf = [&] {
      QStringList titles;
      for (const QTabBar* tabs : w.window.findChildren<QTabBar*>())
        for (int i = 0; i < tabs->count(); ++i)
          if (!tabs->tabIcon(i).isNull()) titles << tabs->tabText(i);
      return titles;
    };
    QTRY_COMPARE(iconsOf(), QStringList({"plots", "scene"}));
  }

  /// Docks that are dragged about, floated, tabbed and closed at random, with layouts and sizes chosen in between: the
  /// layout that is chosen is there afterwards, however the docks lay. GONIO_DOCK_STEPS: more of them.
  void anyLayoutFromAnyState() {
    Window w;
    QVERIFY(QTest::qWaitForWindowExposed(&w.window));
    const int steps = std::max(300, qEnvironmentVariableIntValue("GONIO_DOCK_STEPS"));
    std::mt19937 random(7);
    const auto below = [&](int count) { return int(random() % unsigned(count)); };
    constexpr Qt::DockWidgetArea areas[] = {Qt::LeftDockWidgetArea, Qt::RightDockWidgetArea, Qt::TopDockWidgetArea,
                                            Qt::BottomDockWidgetArea};
    for (int step = 0; step < steps; ++step) {
      QDockWidget* dock = w.docks.docks()[below(int(w.docks.docks().size()))];
      QDockWidget* other = w.docks.docks()[below(int(w.docks.docks().size()))];
      switch (below(9)) {
        case 0:
          dock->setFloating(!dock->isFloating());
          break;
        case 1:
          dock->setVisible(below(2));
          break;
        case 2:
          w.window.addDockWidget(areas[below(4)], dock);
          break;
        case 3:
          if (dock != other) w.window.tabifyDockWidget(other, dock);
          break;
        case 4:
          w.window.resize(700 + below(800), 500 + below(400));
          break;
        case 5:
          if (dock != other && !dock->isFloating() && !other->isFloating())
            w.window.splitDockWidget(other, dock, below(2) ? Qt::Horizontal : Qt::Vertical);
          break;
        case 6:
          w.docks.show(dock->objectName());
          break;
        default:
          drag(*dock, w.window.mapToGlobal(QPoint(below(w.window.width()), below(w.window.height()))));
      }
      QApplication::processEvents();
      if (below(4)) continue;
      w.docks.showWorkspace(Workspace(below(4)));
      QApplication::processEvents();
      QVERIFY(!w.shown().isEmpty());
    }
    w.docks.showWorkspace(Workspace::edit);
    QCOMPARE(w.shown(), QStringList({"library", "inspector"}));
    QCOMPARE(w.window.dockWidgetArea(w.docks.dock("library")), Qt::LeftDockWidgetArea);
    QCOMPARE(w.window.dockWidgetArea(w.docks.dock("inspector")), Qt::RightDockWidgetArea);
    for (const QDockWidget* dock : w.docks.docks()) QVERIFY(!dock->isFloating());
    // Those at the bottom lie behind one another again.
    for (const char* name : {"plots", "comparison", "factors", "scene", "acquisition", "photographs"})
      w.docks.show(name);
    QApplication::processEvents();
    QCOMPARE(w.window.tabifiedDockWidgets(w.docks.dock("plots")).size(), 5);
  }

  /// Qt 6.4 paints a dragged tab into a pixmap of its size and divides by it.
  void tabWithoutSizeIsDragged() {
    QTest::failOnWarning(QRegularExpression("QPainter"));
    Window w;
    for (const char* name : {"plots", "comparison"}) w.docks.show(name);
    QApplication::processEvents();
    const auto bars = w.window.findChildren<QTabBar*>(Qt::FindDirectChildrenOnly);
    QVERIFY(!bars.isEmpty());
    for (QTabBar* bar : bars) {
      const QPoint middle = bar->tabRect(0).center();
      QTest::mousePress(bar, Qt::LeftButton, {}, middle);
      bar->setTabVisible(0, false);
      const QPoint away = middle + QPoint(60, 0);
      QMouseEvent move(QEvent::MouseMove, away, bar->mapToGlobal(away), Qt::NoButton, Qt::LeftButton, {});
      QApplication::sendEvent(bar, &move);
      QTest::mouseRelease(bar, Qt::LeftButton, {}, away);
    }
  }

 private:
  /// By its title bar, as a hand does.
  static void drag(QDockWidget& dock, const QPoint& to) {
    if (!dock.isVisible()) return;
    const QPoint grip(dock.width() / 3, 8);
    const auto send = [&](QEvent::Type type, const QPoint& global, Qt::MouseButton button, Qt::MouseButtons buttons) {
      QMouseEvent event(type, dock.mapFromGlobal(global), global, button, buttons, {});
      QApplication::sendEvent(&dock, &event);
      QApplication::processEvents();
    };
    const QPoint from = dock.mapToGlobal(grip);
    send(QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
    for (int i = 1; i <= 4; ++i) send(QEvent::MouseMove, from + (to - from) * i / 4, Qt::NoButton, Qt::LeftButton);
    send(QEvent::MouseButtonRelease, to, Qt::LeftButton, Qt::NoButton);
  }
};

GONIO_TEST(DockLayoutTest)
}  // namespace dock_layout_test

#include "dock_layout_test.moc"
