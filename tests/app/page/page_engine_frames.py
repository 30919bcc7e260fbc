"""Frames of observers, for the tests of pages."""

import math


def in_board_axes(head_from_board, beta, place):
    """A place in the head's frame with the axes of a rotation-free boost of the board's."""
    gamma = 1 / math.sqrt(1 - sum(b * b for b in beta))
    rows = [[gamma, *[-gamma * b for b in beta]]]
    for i in range(3):
        rows.append([-gamma * beta[i], *[(i == j) + gamma * gamma / (gamma + 1) * beta[i] * beta[j] for j in range(3)]])
    # The rotation: (head from board) after (board from boosted).
    inverse = [[rows[i][j] * (1 if (i == 0) == (j == 0) else -1) for j in range(4)] for i in range(4)]
    head = [[head_from_board[4 * column + row] for column in range(4)] for row in range(4)]
    turn = [[sum(head[i][k] * inverse[k][j] for k in range(4)) for j in range(4)] for i in range(4)]
    return [sum(turn[1 + i][1 + j] * place[i] for i in range(3)) for j in range(3)]
