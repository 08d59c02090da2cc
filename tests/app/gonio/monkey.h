// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QApplication>
#include <QDeadlineTimer>
#include <QDir>
#include <QDockWidget>
#include <QDrag>
#include <QFileDialog>
#include <QMenu>
#include <QTest>
#include <QToolButton>
#include <QWindow>
#include <optional>
#include <random>

#include "app/gonio/window/action_table.h"
#include "app/gonio/window/dock_layout.h"
#include "app/gonio/window/main_window.h"
#include "core/documents/blend_source.h"
#include "core/materials/bundled_library.h"

namespace gonio::app::test_support {

/// A user without a plan, by a seed: clicks, drags, turns the wheel, types, runs commands, opens materials, moves
/// docks, changes layouts, takes back. Events go through the window system's queue, as those of a hand do.
class Monkey : public QObject {
 public:
  /// Disables the commands that end the window, open more of them, or leave the program: the command search finds them.
  /// @param workspace the one that it returns to whenever it would choose one; none: any.
  Monkey(MainWindow& window, unsigned seed, std::optional<DockLayout::Workspace> workspace = {})
      : m_window(window), m_random(seed), m_workspace(workspace) {
    if (workspace) window.docks().showWorkspace(*workspace);
    for (const NamedAction& named : window.actionTable().all()) {
      static const QStringList excluded{"Quit", "New Window", "Close", "Full Screen"};
      const QString text = named.action->text().remove('&');
      if (std::ranges::any_of(excluded, [&](const QString& one) { return text.contains(one); }))
        named.action->setEnabled(false);
    }
  }

  /// For so long; also inside the event loops of dialogs, which are closed in the end.
  void play(int milliseconds) {
    m_end.setRemainingTime(milliseconds);
    m_playLevel = QThread::currentThread()->loopLevel();
    while (!m_end.hasExpired() || isInDialog()) {
      // A dialog may open after the last act.
      if (!m_isScheduled) next();
      QTest::qWait(pauseMilliseconds);
    }
  }
  /// What it did at last, for a report.
  QString lastActs() const { return m_acts.join(QStringLiteral("; ")); }
  int count() const { return m_count; }

 private:
  static constexpr int pauseMilliseconds = 25, patience = 12;

  int below(int count) { return int(m_random() % unsigned(std::max(count, 1))); }
  void note(const QString& act) {
    ++m_count;
    m_acts << act;
    if (m_acts.size() > 30) m_acts.removeFirst();
  }

  /// Where the user's hand goes: a menu that is open, a dialog, any other window.
  QWidget* surface() {
    if (QWidget* popup = QApplication::activePopupWidget()) return popup;
    if (QWidget* modal = QApplication::activeModalWidget()) return modal;
    QWidgetList windows;
    for (QWidget* widget : QApplication::topLevelWidgets())
      if (widget->isVisible() && widget->windowHandle() && widget->windowType() != Qt::ToolTip) windows << widget;
    return windows.isEmpty() || below(4) > 0 ? &m_window : windows[below(int(windows.size()))];
  }

  static bool isInDialog() { return QApplication::activePopupWidget() || QApplication::activeModalWidget(); }

  /// Not by one timer: it would stand still in the loop of a dialog that it has opened.
  void next() {
    m_isScheduled = true;
    QTimer::singleShot(pauseMilliseconds, this, [this] {
      m_isScheduled = false;
      const int level = QThread::currentThread()->loopLevel();
      // An act that is not over may still open a dialog.
      if (m_end.hasExpired() && !isInDialog() && !m_acting && level == m_playLevel) return;
      next();
      // Not in the middle of an act, but in the loop of a dialog that the act has opened.
      if (m_acting && level <= m_level) return;
      if (!m_end.hasExpired()) return act();
      QDrag::cancel();  // an event would end the loop of a drag only while no dialog blocks its window
      if (isInDialog()) surface()->close();
    });
  }

  void act() {
    const bool wasActing = std::exchange(m_acting, true);
    const int outerLevel = std::exchange(m_level, QThread::currentThread()->loopLevel());
    actOn(surface());
    m_level = outerLevel;
    m_acting = wasActing;
  }

  void actOn(QWidget* where) {
    // Files are not its business; a dialog that it does not get rid of goes.
    m_stuck = where == m_lastSurface && where != &m_window ? m_stuck + 1 : 0;
    m_lastSurface = where;
    if (qobject_cast<QFileDialog*>(where) || m_stuck > patience) {
      note("closes " + QString(where->metaObject()->className()));
      m_stuck = 0;
      where->close();
      return;
    }
    if (where != &m_window && where->isWindow() && below(12) == 0) {
      note("closes " + QString(where->metaObject()->className()));
      where->close();
      return;
    }
    const int choice = below(100);
    if (where != &m_window || choice < 35)
      pointer(*where);
    else if (choice < 55)
      key(*where);
    else if (choice < 75)
      command();
    else if (choice < 83)
      openMaterial();
    else if (choice < 93)
      m_window.parts().document.history().undo(), note("undo");
    else
      docks();
  }

  static bool isDraggable(const QWidget* widget) {
    // A drag of a material, of a text or of a dock is handed to the window system, which no test event ends.
    for (const QWidget* one = widget; one; one = one->parentWidget())
      for (const char* source : {"QListView", "QTextEdit", "QLineEdit", "QLabel", "gonio::widgets::MaterialSlotWidget"})
        if (one->inherits(source)) return false;
    // Pressed again while its menu is open, a button starts a second loop over the first, which then never ends.
    const auto* button = qobject_cast<const QToolButton*>(widget);
    if (button && button->menu()) return false;
    return widget && !widget->inherits("QDockWidget");
  }

  void pointer(QWidget& where) {
    QWidgetList targets;
    for (QWidget* widget : where.findChildren<QWidget*>())
      if (widget->isVisible() && !widget->visibleRegion().isEmpty() && widget->window() == &where) targets << widget;
    QWidget* target = targets.isEmpty() ? &where : targets[below(int(targets.size()))];
    QWindow* window = where.windowHandle();
    if (!window) return;
    // A window that is being resized may be smaller than its content.
    const QSize last = window->size() - QSize(1, 1);
    const auto somewhere = [&] {
      const QPoint place = target->mapTo(&where, QPoint(below(target->width()), below(target->height())));
      return QPoint(std::clamp(place.x(), 0, last.width()), std::clamp(place.y(), 0, last.height()));
    };
    const QPoint from = somewhere(), to = somewhere();
    const Qt::KeyboardModifiers modifiers[] = {Qt::NoModifier, Qt::NoModifier, Qt::ShiftModifier, Qt::ControlModifier};
    const Qt::KeyboardModifiers held = modifiers[below(4)];
    const Qt::MouseButton button = below(6) == 0 ? Qt::RightButton : Qt::LeftButton;
    const QString name = target->metaObject()->className();
    const int kind = below(10);
    if (kind < 5) {
      note("click " + name);
      QTest::mouseClick(window, button, held, from);
    } else if (kind < 6) {
      note("double-click " + name);
      QTest::mouseDClick(window, Qt::LeftButton, held, from);
    } else if (kind < 9 && isDraggable(where.childAt(from))) {
      note("drag " + name);
      const QPointer<QWindow> guard = window;
      QTest::mousePress(window, button, held, from);
      for (int i = 1; i <= 5 && guard; ++i) QTest::mouseMove(window, from + (to - from) * i / 5);
      if (guard) QTest::mouseRelease(window, button, held, to);
    } else {
      note("wheel " + name);
      const QPointF place(from);
      QWheelEvent wheel(place, window->mapToGlobal(from), {}, {0, below(2) ? 120 : -120}, Qt::NoButton, held,
                        Qt::NoScrollPhase, false);
      QApplication::sendEvent(window, &wheel);
    }
  }

  void key(QWidget& where) {
    constexpr int keys[] = {Qt::Key_Tab,    Qt::Key_Backtab,   Qt::Key_Left,    Qt::Key_Right, Qt::Key_Up,
                            Qt::Key_Down,   Qt::Key_Home,      Qt::Key_End,     Qt::Key_Space, Qt::Key_Return,
                            Qt::Key_Escape, Qt::Key_Backspace, Qt::Key_0,       Qt::Key_1,     Qt::Key_5,
                            Qt::Key_C,      Qt::Key_V,         Qt::Key_PageDown};
    const auto pressed = Qt::Key(keys[below(int(std::size(keys)))]);
    note("key " + QKeySequence(pressed).toString());
    if (QWindow* window = where.windowHandle()) QTest::keyClick(window, pressed);
  }

  void command() {
    QList<NamedAction> actions;
    for (const NamedAction& named : m_window.actionTable().all())
      if (named.action->isEnabled() && !named.action->menu()) actions << named;
    const NamedAction& chosen = actions[below(int(actions.size()))];
    note(chosen.path);
    chosen.action->trigger();
  }

  /// A blend takes seconds to open: acts that follow edit the document that it will replace.
  static QString slowDocument() {
    const QString path = QDir::current().absoluteFilePath("slow.gonio");
    if (QFile::exists(path)) return path;
    auto blend = std::make_shared<documents::BlendSource>();
    for (const char* id : {"sgd/chrome", "sgd/brass", "sgd/teflon", "sgd/nickel", "sgd/pvc", "sgd/silver-paint"}) {
      documents::EditDocument material;
      material.sourcePath = std::string(materials::libraryScheme) + id;
      material.sourceSha256 = materials::librarySha256(material.sourcePath);
      blend->materials.push_back(material);
      blend->weights.push_back(1.0 / 6);
    }
    documents::EditDocument document;
    document.sourceSha256 = documents::blendSha256(*blend);
    document.blend = std::move(blend);
    documents::writeDocument(document, path.toStdString());
    return path;
  }

  void openMaterial() {
    widgets::LibraryModel& library = m_window.parts().library.model();
    const QString id =
        below(8) == 0 ? slowDocument()
                      : library.index(below(library.materialCount())).data(widgets::LibraryModel::IdRole).toString();
    note("open " + id);
    m_window.files().open(id);
  }

  void docks() {
    const auto all = m_window.findChildren<QDockWidget*>();
    QDockWidget* dock = all[below(int(all.size()))];
    note("dock " + dock->objectName());
    switch (below(4)) {
      case 0:
        return m_window.docks().showWorkspace(m_workspace.value_or(DockLayout::Workspace(below(4))));
      case 1:
        return dock->setFloating(!dock->isFloating());
      case 2:
        return m_window.docks().show(dock->objectName(), dock->isHidden());
      default:
        m_window.resize(900 + below(700), 600 + below(400));
    }
  }

  MainWindow& m_window;
  std::mt19937 m_random;
  const std::optional<DockLayout::Workspace> m_workspace;
  QDeadlineTimer m_end;
  QStringList m_acts;
  QPointer<QWidget> m_lastSurface;
  int m_stuck = 0, m_count = 0, m_level = 0, m_playLevel = 0;
  bool m_acting = false;
  bool m_isScheduled = false;
};

}  // namespace gonio::app::test_support
