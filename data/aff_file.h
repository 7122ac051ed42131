#pragma once

#include "data/aff.h"
#include "data/tokens.h"

#include <set>
#include <string>
#include <vector>

/// How read_aff_model works: one AffFile per file that is read, all adding to one AffReading.
namespace rayshoot {

/// What the files of one scene have in common while they are read.
struct AffReading {
    explicit AffReading(const AffFiles& by_path) : files(by_path) {}

    const AffFiles& files;
    AffModel model;
    std::set<std::string> seen;     ///< paths read so far
    std::vector<std::string> open;  ///< paths being read: the main file and includes within
    std::size_t bytes = 0;          ///< read so far, files counted each time
    int detail = 0;                 ///< includes of a higher level are passed over
};

class AffFile {
public:
    /// `path`: relative to the main file's folder; `name`: for errors; `around`: the transform that
    /// it is included in.
    AffFile(AffReading& reading, std::string text, const std::string& path, const std::string& name,
            std::uint32_t around);
    void read();

private:
    void entity(std::string_view keyword);
    bool shape(std::string_view keyword);
    void light(bool with_key_frames);
    void fill_by_colours();
    void animation();
    void include();
    void open_static();
    void open_animated();
    void open(std::variant<glm::dmat4, std::string> own, const std::string& where);
    void close();
    void key_frames();
    void textured(bool patch);
    void deforming();
    void mesh();
    void expect_brace();
    void add(AffShape shape);
    void leave_out(const std::string& what) { reading_.model.left_out.insert(what); }

    AffReading& reading_;
    std::string text_, path_;
    Tokens tokens_;
    std::vector<std::uint32_t> transforms_;  ///< the one around the file, then those open in it
    bool first_time_;                        ///< this file is read: its things are counted
};

/// `m`: what follows the keyword. `left_out`: textures that were named.
AffMesh read_aff_mesh(Tokens& tokens, std::set<std::string>& left_out);

}  // namespace rayshoot
