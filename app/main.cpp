// main.cpp: the program; everything is in cli/ and workbench.
#include "app/cli/command_line.h"

int main(int argc, char** argv) {
    return neph::runCommandLine(argc, argv);
}
