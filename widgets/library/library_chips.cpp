// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/library/library_chips.h"

#include <QToolButton>
#include <algorithm>

#include "widgets/inputs/flow_layout.h"

namespace gonio::widgets {

LibraryChips::LibraryChips(const LibraryModel& model, QWidget* parent) : QWidget(parent), m_model(model) {
  auto* layout = new FlowLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(3);
  connect(&model, &QAbstractItemModel::modelReset, this, &LibraryChips::rebuild);
  rebuild();
}

void LibraryChips::rebuild() {
  for (QToolButton* chip : m_chips) delete chip;
  m_chips.clear();
  m_filter = {};
  QStringList badges, kinds;
  for (int row = 0; row < m_model.rowCount(); ++row) {
    if (m_model.headingOf(row) != LibraryGrouping::none) continue;
    badges << m_model.index(row).data(LibraryModel::BadgeRole).toString();
    kinds << m_model.group(row, LibraryGrouping::kind);
  }
  kinds.sort(Qt::CaseInsensitive);
  for (QStringList* list : {&badges, &kinds}) {
    list->removeAll(QString());
    list->removeDuplicates();
  }
  addChip(tr("Favourites"), tr("Only materials that are marked as favourites"),
          [this](bool on) { m_filter.favourites = on; });
  const auto member = [](QStringList& list, const QString& text, bool on) {
    on ? list.append(text) : void(list.removeAll(text));
  };
  for (const QString& badge : badges)
    addChip(badge, tr("Only what is \"%1\"").arg(badge),
            [this, member, badge](bool on) { member(m_filter.badges, badge, on); });
  for (const QString& kind : kinds)
    addChip(kind, tr("Only materials of the kind \"%1\"").arg(kind),
            [this, member, kind](bool on) { member(m_filter.kinds, kind, on); });
  Q_EMIT filterChanged();
}

void LibraryChips::addChip(const QString& text, const QString& toolTip, std::function<void(bool)> toggled) {
  auto* chip = new QToolButton;
  chip->setText(text);
  chip->setToolTip(toolTip);
  chip->setCheckable(true);
  chip->setFocusPolicy(Qt::StrongFocus);
  layout()->addWidget(chip);
  m_chips.push_back(chip);
  connect(chip, &QToolButton::toggled, this, [this, toggled = std::move(toggled)](bool on) {
    toggled(on);
    Q_EMIT filterChanged();
  });
}

void LibraryChips::clear() {
  for (QToolButton* chip : m_chips) chip->setChecked(false);
}

QToolButton* LibraryChips::chip(const QString& text) const {
  const auto found = std::ranges::find_if(m_chips, [&](const QToolButton* one) { return one->text() == text; });
  return found == m_chips.end() ? nullptr : *found;
}

}  // namespace gonio::widgets

#include "moc_library_chips.cpp"
