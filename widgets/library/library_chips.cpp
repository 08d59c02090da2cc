// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/library/library_chips.h"

#include <QEvent>
#include <QHash>
#include <QToolButton>
#include <algorithm>
#include <utility>

#include "widgets/inputs/flow_layout.h"
#include "widgets/inputs/menu_text.h"

namespace gonio::widgets {

namespace {
QString sentenceCase(const QString& text) { return text.left(1).toUpper() + text.mid(1); }

/// A button with the accent colour while it is pressed: the style's own look is hard to see on a dark ground.
class Chip final : public QToolButton {
 public:
  Chip() {
    setCheckable(true);
    connect(this, &QToolButton::toggled, this, &Chip::colour);
  }

 protected:
  /// A new theme sets the palette of each widget, and its style sheet takes it away again.
  void changeEvent(QEvent* event) override {
    QToolButton::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange) colour();
  }

 private:
  void colour() {
    if (std::exchange(m_colouring, true)) return;
    QPalette palette;
    if (isChecked()) {
      palette.setColor(QPalette::Button, palette.color(QPalette::Highlight));
      palette.setColor(QPalette::ButtonText, palette.color(QPalette::HighlightedText));
    }
    setPalette(palette);
    m_colouring = false;
  }

  bool m_colouring = false;
};
}  // namespace

LibraryChips::LibraryChips(const LibraryModel& model, QWidget* parent) : QWidget(parent), m_model(model) {
  auto* layout = new FlowLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(3);
  connect(&model, &QAbstractItemModel::modelReset, this, &LibraryChips::rebuild);
  connect(&model, &LibraryModel::notesChanged, this, &LibraryChips::followTags);
  connect(&model, &LibraryModel::notesReplaced, this, &LibraryChips::followTags);
  rebuild();
}

/// What is pressed stays so where the library still has it.
void LibraryChips::rebuild() {
  for (QToolButton* chip : m_chips) delete chip;
  m_chips.clear();
  QStringList badges, kinds;
  QHash<QString, QString> meanings;
  for (int row = 0; row < m_model.rowCount(); ++row) {
    if (m_model.headingOf(row) != LibraryGrouping::none) continue;
    const QModelIndex index = m_model.index(row);
    badges << index.data(LibraryModel::BadgeRole).toString();
    meanings[badges.back()] = index.data(LibraryModel::BadgeMeaningRole).toString();
    kinds << m_model.group(row, LibraryGrouping::kind);
  }
  kinds.sort(Qt::CaseInsensitive);
  for (QStringList* list : {&badges, &kinds}) {
    list->removeAll(QString());
    list->removeDuplicates();
  }
  m_tags = m_model.tags();
  const auto keep = [](QStringList& wanted, const QStringList& present) {
    wanted.removeIf([&](const QString& text) { return !present.contains(text); });
  };
  keep(m_filter.badges, badges);
  keep(m_filter.kinds, kinds);
  keep(m_filter.tags, m_tags);
  addChip(tr("Favourites"), tr("Shows only favourites"), m_filter.favourites);
  addChip(tr("Recent"), tr("Shows only materials opened in the last week"), m_filter.recent);
  for (const QString& badge : badges) {
    const QString toolTip = tr("Shows only materials with the badge \"%1\"").arg(badge);
    addMember(badge, (toolTip + '\n' + meanings[badge]).trimmed(), m_filter.badges)->setText(sentenceCase(badge));
  }
  for (const QString& kind : kinds)
    addMember(kind, tr("Shows only materials of the kind \"%1\"").arg(kind), m_filter.kinds);
  for (const QString& tag : m_tags)
    addMember(tag, tr("Shows only materials with the tag \"%1\"").arg(tag), m_filter.tags);
  Q_EMIT filterChanged();
}

void LibraryChips::followTags() {
  if (m_model.tags() != m_tags) rebuild();
}

QToolButton* LibraryChips::addButton(const QString& text, const QString& toolTip) {
  auto* chip = new Chip;
  chip->setText(menuText(text));
  chip->setToolTip(toolTip);
  chip->setFocusPolicy(Qt::StrongFocus);
  layout()->addWidget(chip);
  m_chips.push_back(chip);
  return chip;
}

void LibraryChips::addChip(const QString& text, const QString& toolTip, bool& wanted) {
  QToolButton* chip = addButton(text, toolTip);
  chip->setChecked(wanted);
  connect(chip, &QToolButton::toggled, this, [this, &wanted](bool on) {
    wanted = on;
    Q_EMIT filterChanged();
  });
}

QToolButton* LibraryChips::addMember(const QString& text, const QString& toolTip, QStringList& list) {
  QToolButton* chip = addButton(text, toolTip);
  chip->setChecked(list.contains(text));
  connect(chip, &QToolButton::toggled, this, [this, &list, text](bool on) {
    list.removeAll(text);
    if (on) list << text;
    Q_EMIT filterChanged();
  });
  return chip;
}

void LibraryChips::clear() {
  for (QToolButton* chip : m_chips) chip->setChecked(false);
}

QToolButton* LibraryChips::chip(const QString& text) const {
  const auto found = std::ranges::find_if(
      m_chips, [&](const QToolButton* one) { return one->text().compare(menuText(text), Qt::CaseInsensitive) == 0; });
  return found == m_chips.end() ? nullptr : *found;
}

}  // namespace gonio::widgets

#include "moc_library_chips.cpp"
