package frustum.driver.raster

import frustum.contract.raster.{
  BeginLayout,
  Command,
  FramePass,
  PackedTriangle,
  PackedVertex,
  TileRegion,
  TriangleLayout
}

/** Takes wire commands apart again, by the book of [[Command]]; strict, because it only serves tests. */
object WireDecoder {
  final case class Message(command: Command, payload: IndexedSeq[Int])

  /** The commands of a byte stream. */
  def messages(bytes: Seq[Int]): Seq[Message] =
    bytes.mkString(" ").split(s"(^| )${Command.Flag} ").toSeq.map(_.trim).filter(_.nonEmpty).map { text =>
      val body = unescape(text.split(" ").map(_.toInt).toList)
      val (content, sum) = body.splitAt(body.length - 2)
      require(Command.crc(content) == (sum(0) << 8 | sum(1)), "checksum")
      val words = content.drop(2).grouped(2).map(p => p(0) << 8 | p(1)).toIndexedSeq
      require(words.length == content(1), s"length ${content(1)} but ${words.length} words")
      Message(Command.all.find(_.opcode == content(0)).get, words)
    }

  /** The pass that a stream from `begin` to `draw` describes; render states stay words. */
  def pass(all: Seq[Message]): (FramePass, Seq[Seq[Int]]) = {
    require(all.head.command == Command.Begin && all.last.command == Command.Draw)
    val begin = all.head.payload
    val vertices = scala.collection.mutable.ArrayBuffer.empty[PackedVertex]
    val triangles = scala.collection.mutable.ArrayBuffer.empty[PackedTriangle]
    val states = scala.collection.mutable.ArrayBuffer.empty[Seq[Int]]
    all.foreach { m =>
      m.command match {
        case Command.State =>
          require(m.payload(0) == states.length)
          states += m.payload.drop(1)
        case Command.Vertices =>
          require(m.payload(0) == vertices.length)
          vertices ++= m.payload.drop(1).grouped(PackedVertex.WireWords).map(PackedVertex.decode)
        case Command.Triangles =>
          m.payload.drop(1).grouped(TriangleLayout.words).foreach { w =>
            val t = PackedTriangle.decode(m.payload(0), w)
            require(Seq(t.v0, t.v1, t.v2).forall(_ < vertices.length), "triangle before its vertices")
            require(t.state < states.length, "triangle before its state")
            triangles += t
          }
        case _ =>
      }
    }
    require(all.last.payload == Seq(vertices.length, triangles.length), "counts")
    import BeginLayout._
    val region = TileRegion(X0.of(begin), Y0.of(begin), X1.of(begin), Y1.of(begin))
    (
      FramePass(begin(0), begin(1), region, IndexedSeq.empty, vertices.toIndexedSeq, triangles.toIndexedSeq),
      states.toSeq
    )
  }

  private def unescape(bytes: List[Int]): List[Int] = bytes match {
    case Command.Escape :: b :: rest => (b ^ Command.EscapeXor) :: unescape(rest)
    case b :: rest                   => b :: unescape(rest)
    case Nil                         => Nil
  }
}
