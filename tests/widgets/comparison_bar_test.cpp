// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/comparison_bar.h"

#include <QApplication>
#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QDropEvent>
#include <QMimeData>
#include <QSignalSpy>
#include <QTest>
#include <QUrl>

#include "tests/support/test_program.h"
#include "widgets/library/material_drag.h"

namespace comparison_bar_test {
using namespace gonio::widgets;

/// The list whose accessible name is that.
QComboBox* list(const ComparisonBar& bar, const QString& name) {
  for (auto* box : bar.findChildren<QComboBox*>())
    if (box->accessibleName() == name) return box;
  return nullptr;
}

class ComparisonBarTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void init() {
    qRegisterMetaType<ComparedSubject>("gonio::widgets::ComparedSubject");
    bar_ = std::make_unique<ComparisonBar>();
    bar_->setSubjects({"Measured", "Fit: GGX", "Edited", ""});
    bar_->setSides(ComparedSubject::edited, ComparedSubject::measured);
    bar_->show();
  }

  /// Each mode shows what it needs and nothing else.
  void modesShowTheirControls() {
    QVERIFY(!list(*bar_, "First side")->isVisible());
    bar_->setComparison({.mode = CompareMode::split});
    QVERIFY(list(*bar_, "First side")->isVisible());
    QVERIFY(!list(*bar_, "Kind of difference")->isVisible());
    bar_->setComparison({.mode = CompareMode::difference});
    QVERIFY(list(*bar_, "Kind of difference")->isVisible());
  }

  void aPressedModeIsTold() {
    QSignalSpy reported(bar_.get(), &ComparisonBar::comparisonEdited);
    bar_->findChild<QButtonGroup*>()->button(int(CompareMode::twoUp))->click();
    QCOMPARE(reported.count(), 1);
    QCOMPARE(reported.front().front().value<PreviewComparison>().mode, CompareMode::twoUp);
  }

  /// The subject of the other side exchanges the two: a side against itself reports nothing.
  void choosingTheOtherSideExchanges() {
    bar_->setComparison({.mode = CompareMode::split});
    std::pair<ComparedSubject, ComparedSubject> reported{};
    connect(bar_.get(), &ComparisonBar::sidesEdited, this, [&](auto a, auto b) { reported = {a, b}; });
    choose("First side", int(ComparedSubject::measured));
    QCOMPARE(reported, (std::pair{ComparedSubject::measured, ComparedSubject::edited}));
    choose("Second side", int(ComparedSubject::fit));
    QCOMPARE(reported, (std::pair{ComparedSubject::edited, ComparedSubject::fit}));
  }

  /// The last entry asks for a material and leaves the side as it was until there is one.
  void anotherMaterialIsAskedFor() {
    bar_->setComparison({.mode = CompareMode::split});
    QSignalSpy wanted(bar_.get(), &ComparisonBar::referenceRequested);
    choose("Second side", 4);
    QCOMPARE(wanted.count(), 1);
    QCOMPARE(list(*bar_, "Second side")->currentIndex(), int(ComparedSubject::measured));
  }

  /// A material dragged out of the library, and a file, are reported when they are dropped here; other things are
  /// refused.
  void aDroppedMaterialIsToldAsReference() {
    QStringList dropped;
    connect(bar_.get(), &ComparisonBar::referenceDropped, this, [&](const QString& path) { dropped << path; });
    const auto drop = [&](QMimeData* data) {
      const std::unique_ptr<QMimeData> owned(data);
      const QPoint at = bar_->rect().center();
      QDragEnterEvent enter(at, Qt::CopyAction, data, Qt::LeftButton, Qt::NoModifier);
      enter.ignore();
      QApplication::sendEvent(bar_.get(), &enter);
      if (!enter.isAccepted()) return false;
      QDropEvent event(at, Qt::CopyAction, data, Qt::LeftButton, Qt::NoModifier);
      QApplication::sendEvent(bar_.get(), &event);
      return true;
    };
    QVERIFY(drop(toDrag("library:sgd/nickel")));
    auto* file = new QMimeData;
    file->setUrls({QUrl::fromLocalFile("/tmp/a.binary")});
    QVERIFY(drop(file));
    auto* text = new QMimeData;
    text->setText("hello");
    QVERIFY(!drop(text));
    QCOMPARE(dropped, (QStringList{"library:sgd/nickel", "/tmp/a.binary"}));
  }

  /// A range of its own is kept until the box for the automatic one is ticked again.
  void rangeIsAutomaticOrGiven() {
    bar_->setComparison({.mode = CompareMode::difference});
    bar_->setFoundRange(0.2);
    auto* automatic = bar_->findChild<QCheckBox*>();
    QVERIFY(automatic->isChecked());
    QSignalSpy reported(bar_.get(), &ComparisonBar::comparisonEdited);
    automatic->click();
    QCOMPARE(reported.back().front().value<PreviewComparison>().range, 0.2);
    automatic->click();
    QCOMPARE(reported.back().front().value<PreviewComparison>().range, 0.0);
  }

 private:
  void choose(const QString& name, int index) {
    QComboBox* box = list(*bar_, name);
    box->setCurrentIndex(index);
    Q_EMIT box->activated(index);
  }

  std::unique_ptr<ComparisonBar> bar_;
};

GONIO_TEST(ComparisonBarTest)
}  // namespace comparison_bar_test

#include "comparison_bar_test.moc"
