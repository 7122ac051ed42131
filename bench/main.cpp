#include "bench/command_line.h"

int main(int argc, char** argv) {
    return rayshoot::run(rayshoot::built_in_catalogue(), argc, argv);
}
