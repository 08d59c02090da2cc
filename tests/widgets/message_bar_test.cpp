// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/panels/message_bar.h"

#include <QLabel>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

#include "tests/support/test_program.h"

namespace message_bar_test {
using gonio::widgets::MessageBar;

QString shown(const MessageBar& bar) { return bar.isHidden() ? QString() : bar.findChild<QLabel*>()->text(); }

class MessageBarTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// A failure of the preview comes again with each change of the material.
  void aRepeatedMessageIsShownOnce() {
    MessageBar bar;
    for (int i = 0; i < 100; ++i) bar.showMessage("no OpenGL");
    QCOMPARE(shown(bar), "no OpenGL");
    bar.showMessage("no disk");
    bar.showMessage("no OpenGL");
    QCOMPARE(shown(bar), "no disk\nno OpenGL");
  }

  void itsHeightIsBounded() {
    MessageBar bar;
    for (int i = 0; i < 100; ++i) bar.showMessage(QString::number(i));
    QCOMPARE(shown(bar), "95\n96\n97\n98\n99");
  }

  void dismissedMessagesAreGone() {
    MessageBar bar;
    bar.showMessage("first");
    bar.findChild<QToolButton*>()->click();
    QCOMPARE(shown(bar), QString());
    bar.showMessage("second");
    QCOMPARE(shown(bar), "second");
  }

  void messagesThatAreNoLongerTrueAreWithdrawn() {
    MessageBar bar;
    bar.showMessage("locked");
    bar.showMessage("full");
    bar.withdraw("slow");
    QCOMPARE(shown(bar), "locked\nfull");
    bar.withdraw("locked");
    QCOMPARE(shown(bar), "full");
    bar.withdraw("full");
    QVERIFY(bar.isHidden());
    bar.showProposal("apply?");
    bar.withdraw("apply?");
    QVERIFY(bar.isProposal());
  }

  /// A proposal stands below the messages, and a message takes its place.
  void aMessageDiscardsAProposal() {
    MessageBar bar;
    const QSignalSpy discarded(&bar, &MessageBar::discarded);
    bar.showMessage("first");
    bar.showProposal("apply?");
    QVERIFY(bar.isProposal() && shown(bar) == "first\napply?");
    bar.showMessage("second");
    QCOMPARE(shown(bar), "first\nsecond");
    QCOMPARE(discarded.count(), 1);
  }
};

GONIO_TEST(MessageBarTest)
}  // namespace message_bar_test

#include "message_bar_test.moc"
