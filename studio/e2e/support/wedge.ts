/** A wedge of 200 × 150 × 100 mm whose file has its sizes in metres (OFF). */
export const WEDGE_IN_METRES = 'OFF\n4 4 0\n0 0 0\n0.2 0 0\n0 0.15 0\n0 0 0.1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n';
