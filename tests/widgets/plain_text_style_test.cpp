// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/inputs/plain_text_style.h"

#include <QApplication>
#include <QHeaderView>
#include <QHelpEvent>
#include <QInputDialog>
#include <QLabel>
#include <QMessageBox>
#include <QProgressDialog>
#include <QStandardItemModel>
#include <QStyleFactory>
#include <QTest>
#include <QToolTip>
#include <QTreeView>
#include <memory>

#include "tests/support/test_program.h"

namespace plain_text_style_test {
using namespace gonio::widgets;

const QString markup = QStringLiteral("<h1>gold</h1><img src='/dev/zero'>");
const QString formula = QStringLiteral("<i>k</i><sub>d</sub>");

/// The label of the tooltip that is shown; null: none.
const QLabel* shownToolTip() {
  for (const QWidget* window : QApplication::topLevelWidgets())
    if (window->inherits("QTipLabel") && window->isVisible()) return qobject_cast<const QLabel*>(window);
  return nullptr;
}

void hover(QWidget& widget, const QPoint& at = {5, 5}) {
  QHelpEvent event(QEvent::ToolTip, at, widget.mapToGlobal(at));
  QApplication::sendEvent(&widget, &event);
}

#define VERIFY_TOOL_TIP(expected, format)            \
  do {                                               \
    const QLabel* label = shownToolTip();            \
    QVERIFY(label);                                  \
    QCOMPARE(label->text(), expected);               \
    QCOMPARE(int(label->textFormat()), int(format)); \
  } while (false)

class PlainTextStyleTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    QApplication::setStyle(new PlainTextStyle(QStyleFactory::create("Fusion")));
    qApp->setStyleSheet("QFrame#none { border: none; }");  // wraps the style, as in the editor
  }
  void cleanup() { QToolTip::hideText(); }

  void labels() {
    QLabel plain(markup), rich(formula);
    rich.setTextFormat(Qt::RichText);
    plain.show();
    rich.show();
    QCOMPARE(int(plain.textFormat()), int(Qt::PlainText));
    QCOMPARE(int(rich.textFormat()), int(Qt::RichText));
    const int height = plain.sizeHint().height();
    plain.setText("gold");
    QCOMPARE(plain.sizeHint().height(), height);
  }

  /// Their labels are Qt's own.
  void dialogs() {
    QMessageBox box(QMessageBox::Question, "Title", markup, QMessageBox::Yes);
    box.setInformativeText(markup);
    QInputDialog input;
    input.setLabelText(markup);
    QProgressDialog progress;
    progress.setLabelText(markup);
    for (QDialog* dialog : std::initializer_list<QDialog*>{&box, &input, &progress}) {
      dialog->show();
      int found = 0;
      for (const QLabel* label : dialog->findChildren<QLabel*>()) {
        QVERIFY(label->textFormat() == Qt::PlainText);
        found += label->text() == markup;
      }
      QCOMPARE(found, dialog == &box ? 2 : 1);
    }
  }

  /// Also where Qt uses one label for both.
  void toolTipsOfWidgets() {
    QWidget plain, rich;
    plain.setToolTip(markup);
    setRichToolTip(rich, formula);
    plain.show();
    rich.show();
    hover(plain);
    VERIFY_TOOL_TIP(markup, Qt::PlainText);
    hover(rich);
    VERIFY_TOOL_TIP(formula, Qt::RichText);
    hover(plain);
    VERIFY_TOOL_TIP(markup, Qt::PlainText);
    rich.setToolTip(markup);
    hover(rich);
    VERIFY_TOOL_TIP(markup, Qt::PlainText);
  }

  void toolTipsOfItems() {
    QStandardItemModel model(2, 1);
    model.item(0);
    model.setItem(0, new QStandardItem("plain"));
    model.item(0)->setToolTip(markup);
    model.setItem(1, new QStandardItem("rich"));
    model.item(1)->setData(formula, richToolTipRole);
    model.setHeaderData(0, Qt::Horizontal, markup, Qt::ToolTipRole);
    QTreeView view;
    view.setModel(&model);
    view.show();
    const auto hoverRow = [&](int row) { hover(*view.viewport(), view.visualRect(model.index(row, 0)).center()); };
    hoverRow(0);
    VERIFY_TOOL_TIP(markup, Qt::PlainText);
    hoverRow(1);
    VERIFY_TOOL_TIP(formula, Qt::RichText);
    hover(*view.header()->viewport());
    VERIFY_TOOL_TIP(markup, Qt::PlainText);
    model.setHeaderData(0, Qt::Horizontal, formula, richToolTipRole);
    hover(*view.header()->viewport());
    VERIFY_TOOL_TIP(formula, Qt::RichText);
    hoverRow(0);
    VERIFY_TOOL_TIP(markup, Qt::PlainText);
  }

  /// Without an event, as charts show them.
  void toolTipsOfCharts() {
    QWidget chart;
    chart.show();
    showRichToolTip(chart.mapToGlobal(QPoint()), formula, &chart);
    VERIFY_TOOL_TIP(formula, Qt::RichText);
    showRichToolTip(chart.mapToGlobal(QPoint()), formula + formula, &chart);
    VERIFY_TOOL_TIP(formula + formula, Qt::RichText);
    QToolTip::hideText();
    QTRY_VERIFY(!shownToolTip());
    QToolTip::showText(chart.mapToGlobal(QPoint()), markup, &chart);
    VERIFY_TOOL_TIP(markup, Qt::PlainText);
  }
};

GONIO_TEST(PlainTextStyleTest)
}  // namespace plain_text_style_test

#include "plain_text_style_test.moc"
