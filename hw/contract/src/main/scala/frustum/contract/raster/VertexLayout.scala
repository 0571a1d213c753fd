package frustum.contract.raster

import frustum.contract.Layout

/** A vertex on the wire, see [[PackedVertex]]. */
object VertexLayout extends Layout("vertex", wordBits = 16) {
  private val xy = s"two's complement; magnitude at most ${PackedVertex.MaxXy}"
  private val st = s"repeats, two's complement, 16 fraction bits; magnitude at most ${PackedVertex.MaxSt}"

  val X = signed("x", word(0), s"1/16 pixel right of the screen's left edge, $xy")
  val Y = signed("y", word(1), s"1/16 pixel below the screen's top edge, $xy")
  val Z = unsigned("z", word(2), "depth, 0 near to 65535 far")
  val QMantissa = unsigned("qMantissa", word(3), "1/w = qMantissa * 2^(qExponent - 31); 32768 to 65535")
  val QExponent = unsigned("qExponent", bits(4, 15, 11), "0 to 31")
  val S = signed("s", bits(4, 10, 0) ++ word(5), st)
  val T = signed("t", bits(6, 10, 0) ++ word(7), st)
  val R = unsigned("r", bits(8, 15, 8), "0 to 255")
  val G = unsigned("g", bits(8, 7, 0), "0 to 255")
  val B = unsigned("b", bits(9, 15, 8), "0 to 255")
  val A = unsigned("a", bits(9, 7, 0), "0 to 255, 255 opaque")
}

/** A vertex in the scene store: the words of the wire in pairs, without the bits that the accepted range never needs.
  */
object StoredVertex extends Layout("stored vertex", wordBits = 32) {
  private val coordinateBits = 25 // a coordinate is within +-128 repeats

  val X = add(VertexLayout.X.paired)
  val Y = add(VertexLayout.Y.paired)
  val Z = add(VertexLayout.Z.paired)
  val QMantissa = add(VertexLayout.QMantissa.paired)
  val QExponent = add(VertexLayout.QExponent.paired)
  val S = add(VertexLayout.S.paired.narrow(coordinateBits))
  val Tag = unsigned("tag", bits(3, 31, 25), "the number of the frame that it was sent in, modulo 128")
  val T = add(VertexLayout.T.paired.narrow(coordinateBits))
  val R = add(VertexLayout.R.paired)
  val G = add(VertexLayout.G.paired)
  val B = add(VertexLayout.B.paired)
  val A = add(VertexLayout.A.paired)
}
