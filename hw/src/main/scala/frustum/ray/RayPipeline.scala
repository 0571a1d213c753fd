package frustum.ray

import frustum.blackbox.Tech
import frustum.fixed.LockstepPipeline
import frustum.spec.{RayScene, RayShade, Wall}
import spinal.core._
import spinal.lib._
import spinal.lib.misc.pipeline._

/** Centres of what moves, in units; coordinates that the scene holds constant are not looked at. */
case class RayMotionBundle(scene: RayScene) extends Bundle {
  val spheres = Vec.fill(scene.spheres.size)(RayPoint())
  val quads   = Vec.fill(scene.quads.size)(RayPoint())
}

case class RayPoint() extends Bundle {
  val x, y, z                = SInt(12 bits)
  def apply(axis: Int): SInt = Seq(x, y, z)(axis)
}

/** Ray caster without a frame buffer: one pixel a clock, `latency` clocks after `up`, no stalls.
  *
  * `latch`: at the start of the vertical blank, takes `motion`. `line`: once before each row, `lineClocks` or
  * more before its first pixel and after the last pixel of the row before. Everything a pixel needs is the sign
  * of a whole polynomial, see [[frustum.spec.RayProgram]]; checker cells are quotients found bit by bit.
  */
case class RayPipeline(config: RayConfig, tech: Tech = Tech.Generic) extends Component {
  import config.{mode, program, scene}
  val io = new Bundle {
    val motion      = in(RayMotionBundle(scene))
    val latch, line = in Bool ()
    val up          = slave(Flow(NoData())) // row by row
    val down        = master(Flow(RayPixel()))
  }
  private val room              = scene.room
  private def extent(axis: Int) = room.high(axis) - room.low(axis)

  private val quotientBits = (0 to 2).map(a => BigInt(extent(a) >> room.cellBits).bitLength).max.max(1)
  private val divisions    = quotientBits
  private val wallLatency  = divisions + 2

  /** Spheres' shades take longest; all else starts so late that it is ready with them. */
  val shade              = config.shade.map(SphereShade(_, tech))
  val latency: Int       = shade.fold(wallLatency)(s => (s.latency + 1).max(wallLatency))
  private val wallStart  = latency - wallLatency
  private val levelAge   = latency - 1
  private val shadeStart = levelAge - shade.fold(levelAge)(_.latency)

  val setup            = RaySetup(program)
  val setUpClocks: Int = setup.frameClocks
  val lineClocks: Int  = setup.lineClocks + latency + 1
  require(
    setUpClocks <= mode.blankClocks - mode.hTotal,
    s"set-up of $setUpClocks clocks in a blank of ${mode.blankClocks}"
  )
  require(lineClocks <= mode.hBlank, s"row load of $lineClocks clocks in a blank of ${mode.hBlank}")
  require(setup.rowClocks <= mode.width, s"row steps of ${setup.rowClocks} clocks in a row of ${mode.width}")

  setup.io.latch := io.latch
  for ((to, i) <- setup.io.inputs.zip(program.inputs))
    to := (if (i.isSphere) io.motion.spheres else io.motion.quads) (i.index)(i.axis).resized

  val line = new LockstepPipeline(latency)
  line(0).valid := io.up.valid

  /** The last walker must have done the row before. */
  val waiting = RegInit(False)
  setup.io.line := waiting && !line.nodes.last.isValid
  when(setup.io.line)(waiting := False)
  when(io.line)(waiting       := True)

  /** Node at which a form is looked at. */
  private def node(form: String): Int = {
    def isA(names: String*) = names.exists(n => form.startsWith(n))
    if (isA("sphere", "along")) shadeStart
    else shade.filter(_ => isA("towards", "lit", "square")).fold(wallStart) { s =>
      shadeStart + (if (isA("towards")) s.towardsAge else if (isA("lit")) s.litAge else s.squareAge)
    }
  }
  private val walkers = program.forms.map { f =>
    val w = FormWalker(f, program).setName("walk_" + f.name)
    w.io.load := setup.io.load
    w.io.step := line(node(f.name)).isValid
    f.name    -> w.io.value
  }.toMap

  line.nodes.last.ready := True
  require(latency < mode.width, s"latency $latency in rows of ${mode.width}")

  private val widthN     = (0 to 2).map(a => walkers(s"direction$a").getWidth).max + 1
  private val widthU     = walkers.collect { case (n, v) if n.startsWith("across") => v.getWidth }.max
  val SPHERE             = Payload(Bool())
  val SPHERE_INDEX       = Payload(UInt(4 bits))
  val WALL               = Payload(Bits(Wall.all.size bits))
  val QUADS              = Payload(Bits(scene.quads.size.max(1) bits))
  val SHADOW             = Payload(Bool())
  val HITS               = Payload(Bits(Wall.all.size bits))
  val CONES              = Payload(Bits(Wall.all.size bits))
  private val normals    = Seq.fill(3)(Payload(SInt(widthN bits)))
  private val offsets    = Seq.fill(Wall.all.size)(Seq.fill(2)(Payload(UInt(widthU bits))))
  private val QUAD_SIDES = Payload(Bits(scene.quads.size.max(1) bits))
  val N                  = Payload(UInt(widthN bits))
  private val rests      = Seq.fill(divisions + 1)(Seq.fill(2)(Payload(UInt(widthU bits))))
  private val parities   = Seq.fill(divisions)(Seq.fill(2)(Payload(Bool())))

  /** What is hit: signs of the forms at this pixel. */
  val test = new Area {
    val s0 = line(wallStart)

    /** Of walls that meet in an edge, whether the ray meets p no later than q: k_q n_p >= k_p n_q, which is also the
      * border of p across q's axis, and the other way round that of q across p's.
      */
    val before = Wall.pairs.map { case (p, q) =>
      val late = walkers(s"across${q.index}_${p.axis}")
      val sign =
        if (q.sign < 0) !walkers(s"across${p.index}_${q.axis}").msb
        else if (p.sign < 0) late.msb || late === 0
        else !walkers(s"before${p.index}_${q.index}").msb
      (p.index, q.index) -> sign
    }.toMap
    val hits = Wall.all.map { w =>
      val backward = walkers(s"direction${w.axis}").msb
      val others   = Wall.all.filter(_.axis != w.axis).map { q =>
        if (w.index < q.index) before(w.index, q.index) else !before(q.index, w.index)
      }
      // The room has no wall at its front: its border there is the wall's own.
      val front = w.across.filter(u => !Wall.all.exists(q => q.axis == u && q.sign < 0))
      val open  = front.map(u => !walkers(s"across${w.index}_$u").msb)
      (others ++ open).reduce(_ && _) && (if (w.sign > 0) !backward else backward)
    }
    s0(HITS)                         := hits.asBits()
    for (a <- 0 to 2) s0(normals(a)) := walkers(s"direction$a").resized
    for (w <- Wall.all; j <- 0 to 1)
      s0(offsets(w.index)(j)) := walkers(s"across${w.index}_${w.across(j)}").resize(widthU).asUInt
    val quads = scene.quads.indices.map { i =>
      Seq("quad", "quadEnd").flatMap(end => (0 to 1).map(u => !walkers(s"$end${i}_$u").msb)).reduce(_ && _)
    }
    s0(QUAD_SIDES) := (if (quads.isEmpty) B(0, 1 bits) else quads.asBits())
    val shadows = for (_ <- scene.light.toSeq; i <- scene.spheres.indices) yield {
      val cone =
        Wall.all.map(w => walkers(s"gate${i}_${w.index}") > 0 && walkers(s"shadow${i}_${w.index}") >= 0)
      val enclosed = walkers(s"power$i") <= 0
      cone.asBits() | B(Wall.all.size bits, default -> enclosed)
    }
    s0(CONES) := shadows.foldLeft(B(0, Wall.all.size bits))(_ | _)
  }

  /** The first wall hit, and what belongs to it. */
  val select = new Area {
    val s1    = line(wallStart + 1)
    val first = OHMasking.first(s1(HITS))
    s1(WALL) := first
    s1(N)    := MuxOH.or(
      first,
      Wall.all.map { w =>
        val d = s1(normals(w.axis)); (if (w.sign > 0) d else -d).asUInt
      }
    )
    for (j <- 0 to 1) s1(rests.head(j)) := MuxOH.or(first, offsets.map(o => s1(o(j))))
    s1(QUADS)                           := Mux(first.msb, s1(QUAD_SIDES), B(0, scene.quads.size.max(1) bits))
    s1(SHADOW)                          := (s1(CONES) & first).orR
  }

  /** The nearest sphere hit: the one whose centre is nearest along the ray. */
  val nearest = scene.spheres.nonEmpty generate new Area {
    val candidates = scene.spheres.indices.map { i =>
      val along = walkers(s"along$i")
      (walkers(s"sphere$i") >= 0 && along > 0, along, U(i, 4 bits))
    }
    val (hit, _, index) = candidates.reduceLeft { (l, r) =>
      val left  = l._1 && (!r._1 || l._2 <= r._2)
      val width = scala.math.max(l._2.getWidth, r._2.getWidth)
      (l._1 || r._1, Mux(left, l._2.resize(width), r._2.resize(width)), Mux(left, l._3, r._3))
    }
    line(shadeStart)(SPHERE)       := hit
    line(shadeStart)(SPHERE_INDEX) := index
  }

  /** Colour of the nearest sphere, by how far it is lit. */
  val sphereColor                                  = Bits(24 bits)
  private def ofSphere(at: Int)(each: Int => Bits) =
    Vec(scene.spheres.indices.map(each)).read(line(at)(SPHERE_INDEX).resize(log2Up(scene.spheres.size)))
  shade match {
    case Some(s) =>
      def form(to: SInt, name: String, age: Int): Unit =
        to   := ofSphere(shadeStart + age)(i => walkers(s"$name$i").resize(to.getWidth).asBits).asSInt
      s.io.q := ofSphere(shadeStart)(i => walkers(s"sphere$i").resize(s.io.q.getWidth).asBits).asUInt
      form(s.io.towards, "towards", s.towardsAge)
      form(s.io.lit, "lit", s.litAge)
      form(s.io.power, "power", s.powerAge)
      s.io.square := walkers("square").asUInt.resized
      val ramps = scene.spheres.indices.map(config.shade.get.ramp)
      val index = line(levelAge)(SPHERE_INDEX).resize(log2Up(scene.spheres.size)) @@ s.io.level
      val size  = RayShade.Levels << log2Up(scene.spheres.size)
      // A channel that no sphere has needs no memory.
      sphereColor := Seq(16, 8, 0).map { shift =>
        val words = ramps.flatten.map(_ >> shift & 255).padTo(size, 0)
        if (words.forall(_ == 0)) B(0, 8 bits)
        else Mem(Bits(8 bits), words.map(B(_, 8 bits))).readSync(index)
      }.reduce(_ ## _)
    case None if scene.spheres.nonEmpty =>
      sphereColor := ofSphere(latency)(i => B(scene.spheres(i).color, 24 bits))
    case None => sphereColor := 0
  }

  /** Quotients by the checker's cell, a bit a stage; only the last bit is kept. */
  for (k <- 0 until divisions; j <- 0 to 1) {
    val node       = line(wallStart + k + 2)
    val i          = quotientBits - 1 - k
    val width      = scala.math.max(widthU, widthN + room.cellBits + i) + 1
    val rest       = node(rests(k)(j)).resize(width)
    val difference = rest - (node(N) << (room.cellBits + i)).resize(width)
    node(rests(k + 1)(j)) := Mux(difference.msb, rest, difference).resize(widthU)
    node(parities(k)(j))  := !difference.msb
  }

  /** Colours of what is hit. */
  val paint = new Area {
    val last                     = line(latency)
    private def constant(c: Int) = B(c, 24 bits)
    val cells                    = (0 to 2).map { a =>
      Wall.all.map { w =>
        val j   = w.across.indexOf(a)
        val bit = if (j < 0) Bool(w.bit(room)) else last(parities.last(j))
        last(WALL)(w.index) && bit
      }.reduce(_ || _)
    }
    val rgb = Bits(24 bits)
    val id  = UInt(4 bits)
    rgb := cells.flatMap(c => Seq.fill(8)(c)).reverse.asBits()
    id  := 1
    for ((q, i) <- scene.quads.zipWithIndex.reverse)
      when(last(QUADS)(i)) { rgb := constant(q.color); id := 2 + i }
    val shown = Bits(24 bits)
    shown := Mux(last(SHADOW), (rgb |>> 1) & B(0x7f7f7f, 24 bits), rgb)
    val shownId = CombInit(id)
    when(!last(WALL).orR) { shown := constant(scene.background); shownId := 0 }
    if (scene.spheres.nonEmpty) when(last(SPHERE)) {
      shown   := sphereColor
      shownId := last(SPHERE_INDEX) + (2 + scene.quads.size)
    }
    io.down.valid    := last.isValid
    io.down.rgb.r    := shown(23 downto 16).asUInt
    io.down.rgb.g    := shown(15 downto 8).asUInt
    io.down.rgb.b    := shown(7 downto 0).asUInt
    io.down.objectId := shownId
  }
  line.build()
}
