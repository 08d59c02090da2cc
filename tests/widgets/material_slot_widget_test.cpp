// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/interpolation/material_slot_widget.h"
#include "tests/widgets/child.h"

#include <QDropEvent>
#include <QLabel>
#include <QMimeData>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QUrl>

#include "tests/support/test_program.h"
#include "widgets/library/material_drag.h"

namespace material_slot_widget_test {
using namespace gonio::widgets;

class MaterialWellTest : public QObject {
  Q_OBJECT
 private:
  std::unique_ptr<MaterialSlotWidget> m_slot;

  bool drop(const QMimeData& data) {
    QDragEnterEvent enter(QPoint(9, 9), Qt::CopyAction, &data, Qt::LeftButton, {});
    enter.ignore();
    QApplication::sendEvent(m_slot.get(), &enter);
    if (!enter.isAccepted()) return false;
    QDropEvent event(QPointF(9, 9), Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(m_slot.get(), &event);
    return true;
  }
  bool isWritten(const QString& text) const {
    for (const QLabel* label : m_slot->findChildren<QLabel*>())
      if (label->text().contains(text)) return true;
    return false;
  }

 private Q_SLOTS:
  void init() {
    m_slot = std::make_unique<MaterialSlotWidget>('B');
    m_slot->resize(320, 100);
    m_slot->show();
  }

  /// A thumbnail gives the library's id, a file its path; what is neither is not taken.
  void takesThumbnailsAndFiles() {
    QSignalSpy dropped(m_slot.get(), &MaterialSlotWidget::materialDropped);
    const std::unique_ptr<QMimeData> thumbnail(toDrag("library:sgd/nickel"));
    QVERIFY(drop(*thumbnail));
    QMimeData file;
    file.setUrls({QUrl::fromLocalFile("/some/where/chrome.binary")});
    QVERIFY(drop(file));
    QMimeData text;
    text.setText("chrome");
    QVERIFY(!drop(text));
    QMimeData picture;
    picture.setUrls({QUrl::fromLocalFile("/some/where/sky.hdr")});
    QVERIFY(!drop(picture));
    QCOMPARE(dropped.count(), 2);
    QCOMPARE(dropped[0][0].toString(), QStringLiteral("library:sgd/nickel"));
    QCOMPARE(dropped[1][0].toString(), QStringLiteral("/some/where/chrome.binary"));
  }

  void tellsWhatWillHappen() {
    QVERIFY(isWritten("Drop a material here"));
    const std::unique_ptr<QMimeData> thumbnail(toDrag("library:sgd/nickel"));
    QDragEnterEvent enter(QPoint(9, 9), Qt::CopyAction, thumbnail.get(), Qt::LeftButton, {});
    QApplication::sendEvent(m_slot.get(), &enter);
    QVERIFY(isWritten("Drop to use as material B"));
    QDragLeaveEvent leave;
    QApplication::sendEvent(m_slot.get(), &leave);
    QVERIFY(isWritten("Drop a material here"));
  }

  void showsNameAndNote() {
    m_slot->setContent({.name = "nickel", .toolTip = "SGD fit", .picture = {}, .note = "40 %"});
    QVERIFY(isWritten("nickel") && isWritten("40 %"));
    QVERIFY(m_slot->accessibleName().contains("nickel") && m_slot->toolTip().contains("SGD fit"));
    m_slot->setContent({.name = QString(200, 'x'), .toolTip = {}, .picture = {}});
    QVERIFY(m_slot->minimumSizeHint().width() < 320);
  }

  /// All of it by keys: the buttons are in the tab order, Delete empties, and only what is there can be emptied.
  void theKeyboardReachesAll() {
    QSignalSpy current(m_slot.get(), &MaterialSlotWidget::currentRequested),
        file(m_slot.get(), &MaterialSlotWidget::fileRequested),
        cleared(m_slot.get(), &MaterialSlotWidget::clearRequested);
    m_slot->setFocus();
    QTest::keyClick(m_slot.get(), Qt::Key_Delete);
    QCOMPARE(cleared.count(), 0);
    m_slot->setContent({.name = "nickel", .toolTip = {}, .picture = {}});
    QTest::keyClick(m_slot.get(), Qt::Key_Delete);
    QCOMPARE(cleared.count(), 1);
    for (QToolButton* button : m_slot->findChildren<QToolButton*>()) {
      QVERIFY(button->focusPolicy() & Qt::TabFocus && !button->accessibleName().isEmpty());
      button->setFocus();
      QTest::keyClick(button, Qt::Key_Space);
    }
    QCOMPARE(current.count(), 1);
    QCOMPARE(file.count(), 1);
    QCOMPARE(cleared.count(), 2);
    m_slot->setCurrentAvailable(false);
    QVERIFY(!gonio::test::child<QToolButton>(*m_slot, "Current")->isEnabled());
  }
};

GONIO_TEST(MaterialWellTest)
}  // namespace material_slot_widget_test

#include "material_slot_widget_test.moc"
