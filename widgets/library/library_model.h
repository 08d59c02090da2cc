// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QAbstractListModel>
#include <QDateTime>
#include <QHash>
#include <QImage>
#include <QPixmap>
#include <QString>
#include <QStringList>
#include <functional>
#include <optional>
#include <vector>

#include "core/math/types.h"

namespace gonio::widgets {

/// The user's notes about a library material.
struct LibraryNote {
  static constexpr int maxRating = 5;

  bool favourite = false;
  int rating = 0;  ///< 1 to 5; 0: none
  QStringList tags = {};
  QDateTime opened = {};  ///< last time; null: never

  bool isEmpty() const { return *this == LibraryNote{}; }
  bool operator==(const LibraryNote&) const = default;
};

/// Notes by the id of the material, over all libraries.
using LibraryNotes = QHash<QString, LibraryNote>;

/// The tags of a comma-separated text, each once, in order.
QStringList tagsOf(const QString& text);

/// A material that can be opened from the library.
struct LibraryItem {
  QString id;                 ///< argument for opening it: a path, or "library:sgd/chrome"
  QString name;               ///< shown with spaces for underscores
  QString toolTip;            ///< the format, and what the material is
  QString badge = {};         ///< one or two words on the picture, e.g. "measured"
  QString source = {};        ///< heading of its group by source; empty: none
  QString kind = {};          ///< heading of its group by kind, also used in searches, e.g. "Metal"
  qint64 version = 0;         ///< changes with the content, which invalidates the thumbnail
  QString badgeMeaning = {};  ///< one sentence that explains the badge
  QString material = {};      ///< items of one material in several qualities have it in common; empty: there is one
};

enum class LibraryGrouping { none, source, kind };

/// Properties of a material from its rendered thumbnail.
struct LibraryThumbnail {
  QImage image;
  double hue = 0;        ///< of the image, degrees; -1 for greys
  double roughness = 0;  ///< width of the highlight, GGX alpha
};

/// The rows of a library: one per item, the best quality of a material first, then one per heading. Other objects
/// render the thumbnails and set them.
class LibraryModel : public QAbstractListModel {
  Q_OBJECT

 public:
  enum Role {
    IdRole = Qt::UserRole,
    HueRole,
    LightnessRole,
    RoughnessRole,
    DissimilarityRole,
    FailureRole,
    FailureBadgeRole,
    BadgeRole,
    BadgeMeaningRole,
    HeadingRole,
    FavouriteRole,
    RatingRole,  ///< 0 to 5
    RatingOrderRole,
    TagsRole,
    OpenedRole,  ///< null: never opened
    OpenedOrderRole,
    LookRole  ///< words for the look of the thumbnail and for the kind: "shiny red carpaint"
  };

  using QAbstractListModel::QAbstractListModel;

  /// Thumbnails of existing materials with the same version are not removed.
  void setItems(std::vector<LibraryItem> items);
  /// Removes all materials until setItems() is called.
  void beginListing();
  bool isListing() const { return m_listing; }
  void setThumbnail(const QString& id, const LibraryThumbnail& thumbnail);
  /// Why a material has no picture: the reason is shown in its tooltip, `badge` on its tile.
  void setFailure(const QString& id, const QString& reason, const QString& badge = {});
  /// Sets the thumbnail with which DissimilarityRole compares; empty: no order.
  void setReference(const std::optional<LibraryThumbnail>& thumbnail);
  /// Null if there is none yet.
  const LibraryThumbnail* thumbnail(const QString& id) const;
  void setNotes(LibraryNotes notes);
  LibraryNote note(const QString& id) const { return m_notes.value(id); }
  void setNote(const QString& id, const LibraryNote& note);
  /// Changes the notes of several materials at once.
  void changeNotes(const QStringList& ids, const std::function<void(LibraryNote&)>& change);
  /// The tags of all materials, each once, in alphabetical order.
  QStringList tags() const;
  /// Ids without a thumbnail and without a failure, in order.
  QStringList pending() const;

  /// The grouping of a heading row; `none` for a material.
  LibraryGrouping headingOf(int row) const;
  /// The heading of a row's group, by which groups are sorted; "" if there is none.
  QString group(int row, LibraryGrouping grouping) const;
  int groupRank(int row, LibraryGrouping grouping) const;
  /// The rows of all qualities of a row's material, the best one first; the row alone if there are no others.
  std::vector<int> qualities(int row) const;
  /// The ids of these rows; empty for an unknown id.
  QStringList qualitiesOf(const QString& id) const;
  QString badge(const QString& id) const;

  int materialCount() const { return int(m_entries.size()); }
  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  QMimeData* mimeData(const QModelIndexList& indexes) const override;

 Q_SIGNALS:
  /// The changed notes; an empty note was removed.
  void notesChanged(const gonio::widgets::LibraryNotes& notes);
  /// All notes, by setNotes().
  void notesReplaced();

 private:
  struct Entry {
    LibraryItem item;
    std::optional<LibraryThumbnail> thumbnail;
    Rgb lab{0};  ///< of the thumbnail
    QPixmap pixmap;
    QString failure, failureBadge;
    QString look;  ///< lookWords() of the thumbnail
  };
  struct Heading {
    QString title;
    LibraryGrouping grouping;
  };
  void addHeadings(LibraryGrouping grouping, const QStringList& titles);
  int find(const QString& id) const;
  QString toolTip(const Entry& entry) const;
  const Heading* heading(int row) const;

  std::vector<Entry> m_entries;
  std::vector<Heading> m_headings;
  QHash<QString, std::vector<int>> m_qualities;  ///< rows by LibraryItem::material
  LibraryNotes m_notes;
  bool m_listing = false;
  struct Reference {
    Rgb lab;
    double roughness;
  };
  std::optional<Reference> m_reference;
};

/// Words by which people search for a look, from the thumbnail: its colour ("red", "dark") and the width of its
/// highlight
/// ("mirror", "shiny", "matt"). @param lab the mean colour, CIE L*, a*, b*.
QString lookWords(const LibraryThumbnail& thumbnail, const Rgb& lab);

/// The mean of a picture's opaque pixels, in linear light, as CIE L*, a*, b*; black if there are none.
Rgb meanLab(const QImage& picture);

/// Dissimilarity of two materials by their thumbnails: the Euclidean norm of the colour difference (CIE 1976 delta E)
/// and 10 per octave of roughness. 0: equal.
double dissimilarity(const Rgb& lab, double roughness, const Rgb& otherLab, double otherRoughness);

}  // namespace gonio::widgets
