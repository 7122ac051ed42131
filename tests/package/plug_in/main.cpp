#include "bench/command_line.h"
#include "mine_entry.h"

int main(int argc, char** argv) {
    rayshoot::Catalogue catalogue = rayshoot::built_in_catalogue();
    catalogue.push_back(rayshoot::mine_entry());
    return rayshoot::run(catalogue, argc, argv);
}
